// SPDX-License-Identifier: GPL-3.0-or-later
// A server for the built page, like any static host: below a path, compressed, with tags for unchanged files and no extra
// headers.
import { createHash } from 'node:crypto';
import { readFileSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

const kFolder = fileURLToPath(new URL('../../dist', import.meta.url));

/** @type {Record<string, string>} */
const kTypes = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.webp': 'image/webp',
  '.webmanifest': 'application/manifest+json',
  '.stl': 'model/stl',
  '.txt': 'text/plain',
  '.xml': 'application/xml',
};

/** @type {Map<string, Buffer>} */ const packed = new Map();

export class Site {
  /**
   * @param {string} base      path of the page, between slashes
   * @param {string} [folder]  to serve
   */
  constructor(base, folder = kFolder) {
    this.base = base;
    this.folder_ = folder;
    this.origin = '';
    /** @type {Map<string, (content: string) => string>} */ this.changes = new Map(); // by file, for a new version
    /** @type {{ path: string, bytes: number }[]} */ this.sent = [];
    /** @type {(path: string) => boolean} */ this.lacks = () => false;
    this.types = { ...kTypes };
    this.server_ = createServer((request, response) => this.answer_(request, response));
  }

  get address() {
    return this.origin + this.base;
  }

  async open() {
    await new Promise((resolve) => this.server_.listen(0, '127.0.0.1', () => resolve(undefined)));
    this.origin = `http://127.0.0.1:${/** @type {import('node:net').AddressInfo} */ (this.server_.address()).port}`;
    return this;
  }

  async close() {
    this.server_.closeAllConnections();
    await new Promise((resolve) => this.server_.close(() => resolve(undefined)));
  }

  /** @param {import('node:http').IncomingMessage} request @param {import('node:http').ServerResponse} response */
  answer_(request, response) {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const path = pathname.startsWith(this.base) ? decodeURI(pathname.slice(this.base.length)) || 'index.html' : '..';
    const file = `${this.folder_}/${path}`;
    if (path.includes('..') || this.lacks(path) || !statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404).end();
      return;
    }
    const change = this.changes.get(path);
    const content = change
      ? gzipSync(change(readFileSync(file, 'utf8')))
      : (packed.get(file) ?? gzipSync(readFileSync(file)));
    if (!change) packed.set(file, content);
    const tag = `"${createHash('sha256').update(content).digest('hex')}"`;
    if (request.headers['if-none-match'] === tag) {
      response.writeHead(304, { ETag: tag }).end();
      return;
    }
    this.sent.push({ path, bytes: content.length });
    response
      .writeHead(200, {
        'Content-Type': this.types[extname(path)] ?? 'application/octet-stream',
        'Content-Encoding': 'gzip',
        'Content-Length': content.length,
        'Cache-Control': 'max-age=600',
        ETag: tag,
      })
      .end(content);
  }
}
