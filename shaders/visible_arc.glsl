// Returns the cosine-weighted visibility of one side of a slice [Jimenez 2016]. Angles count from the line of sight: to
// the horizon, and gamma to the normal.
float visibleArc(float horizon, float gamma) {
  return 0.25 * (-cos(2.0 * horizon - gamma) + cos(gamma) + 2.0 * horizon * sin(gamma));
}
