// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/engine.h"
#include "io/write_stl.h"
#include "support/gl_test.h"

namespace qrelief {

/// An engine with a view of 400 × 300 pixels.
class EngineFixture : public GlTest {
 protected:
  static constexpr const char* kSettings = R"({"text": "https://example.org/qrelief-test", "size": "free"})";

  void SetUp() override {
    engine_ = std::make_unique<Engine>();
    engine_->resize(400, 300, 1);
  }
  nlohmann::json load(const Mesh& mesh, const std::string& name = "model.stl") {
    return nlohmann::json::parse(engine_->loadModel(writeStl(mesh), name, 1));
  }
  static void expectError(const std::string& answer, const std::string& kind, const std::string& code) {
    const nlohmann::json json = nlohmann::json::parse(answer);
    EXPECT_EQ(json["ok"], false) << answer;
    EXPECT_EQ(json["error"]["kind"], kind) << answer;
    EXPECT_EQ(json["error"]["code"], code) << answer;
    EXPECT_TRUE(json["error"]["values"].is_object()) << answer;
  }
  std::unique_ptr<Engine> engine_;
};

}  // namespace qrelief
