// What the CGAL drivers of sums share: an exact reader of OFF and XOFF, the report.
#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure.h"

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Rational = Epeck::FT::Exact_type;
using Point = Epeck::Point_3;

// A polygon soup with exact coordinates, as in the file.
struct Soup {
  std::vector<std::array<Rational, 3>> points;
  std::vector<std::vector<std::size_t>> facets;
};

// The rational that "12", "-1.25", "3e-2" or "7/3" writes.
inline Rational parse_rational(const std::string& token) {
  const auto slash = token.find('/');
  if (slash != std::string::npos)
    return parse_rational(token.substr(0, slash)) / parse_rational(token.substr(slash + 1));
  std::string digits;
  long exponent = 0;
  bool negative = false, fraction = false;
  std::size_t i = 0;
  if (i < token.size() && (token[i] == '-' || token[i] == '+')) negative = token[i++] == '-';
  for (; i < token.size(); ++i) {
    const char c = token[i];
    if (c == '.') {
      fraction = true;
    } else if (c == 'e' || c == 'E') {
      exponent += std::stol(token.substr(i + 1));
      break;
    } else if (c >= '0' && c <= '9') {
      digits += c;
      if (fraction) --exponent;
    } else {
      throw std::runtime_error("not a number: " + token);
    }
  }
  if (digits.empty()) throw std::runtime_error("not a number: " + token);
  std::string denominator = "1";
  (exponent > 0 ? digits : denominator).append(static_cast<std::size_t>(std::labs(exponent)), '0');
  // GMP reads a leading zero as the mark of base 8.
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  const Rational value = Rational(digits) / Rational(denominator);
  return negative ? Rational(-value) : value;
}

inline Soup read_off(const std::string& name) {
  std::ifstream file(name);
  if (!file) throw std::runtime_error("cannot open " + name);
  std::stringstream text;
  for (std::string line; std::getline(file, line);) text << line.substr(0, line.find('#')) << '\n';
  std::string token;
  std::size_t vertices = 0, facets = 0, edges = 0;
  text >> token >> vertices >> facets >> edges;
  if (token != "OFF") throw std::runtime_error("no OFF header in " + name);
  Soup soup;
  soup.points.resize(vertices);
  soup.facets.resize(facets);
  for (auto& point : soup.points)
    for (auto& coordinate : point) {
      text >> token;
      coordinate = parse_rational(token);
    }
  for (auto& facet : soup.facets) {
    std::size_t size = 0;
    text >> size;
    facet.resize(size);
    for (auto& index : facet) text >> index;
  }
  if (!text) throw std::runtime_error("short file " + name);
  return soup;
}

inline std::vector<Point> kernel_points(const Soup& soup) {
  std::vector<Point> points;
  points.reserve(soup.points.size());
  for (const auto& p : soup.points) points.emplace_back(Epeck::FT(p[0]), Epeck::FT(p[1]), Epeck::FT(p[2]));
  return points;
}

using Hull = CGAL::Surface_mesh<Point>;

// Joins the coplanar triangles of a convex surface: for every triangle its class, and the boundary of each class.
struct Merged {
  std::vector<std::size_t> class_of;
  std::size_t vertices = 0, edges = 0, facets = 0;
  std::vector<char> is_vertex;
};

inline Merged merge_coplanar(const Hull& hull) {
  Merged merged;
  auto& up = merged.class_of;
  up.resize(hull.number_of_faces());
  std::iota(up.begin(), up.end(), 0);
  auto find = [&](std::size_t x) {
    while (up[x] != x) x = up[x] = up[up[x]];
    return x;
  };
  for (auto edge : hull.edges()) {
    const auto h = hull.halfedge(edge), o = hull.opposite(h);
    if (CGAL::coplanar(hull.point(hull.source(h)), hull.point(hull.target(h)),
                       hull.point(hull.target(hull.next(h))), hull.point(hull.target(hull.next(o)))))
      up[find(hull.face(h))] = find(hull.face(o));
  }
  for (std::size_t i = 0; i < up.size(); ++i) up[i] = find(i);
  for (std::size_t i = 0; i < up.size(); ++i) merged.facets += up[i] == i;
  merged.is_vertex.resize(hull.number_of_vertices());
  for (auto v : hull.vertices()) {
    std::vector<std::size_t> around;
    for (auto f : hull.faces_around_target(hull.halfedge(v))) around.push_back(up[f]);
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    merged.is_vertex[v] = around.size() >= 3;
    merged.vertices += around.size() >= 3;
  }
  merged.edges = merged.vertices + merged.facets - 2;
  return merged;
}

// One JSON object on one line, read by `cargo xtask peers`.
inline void report(const char* method, const Samples& samples, const std::vector<const char*>& names,
                   std::size_t vertices, std::size_t edges, std::size_t facets) {
  std::printf("{\"method\": \"%s\", \"version\": \"CGAL %s\", \"repetitions\": %zu, \"seconds\": %.9f, \"phases\": {",
              method, CGAL_VERSION_STR, samples.totals.size(), median(samples.totals));
  for (std::size_t i = 0; i < names.size(); ++i)
    std::printf("%s\"%s\": %.9f", i ? ", " : "", names[i], median(samples.phases[i]));
  std::printf("}, \"vertices\": %zu, \"edges\": %zu, \"facets\": %zu}\n", vertices, edges, facets);
}

// `driver A B [LEAST [SECONDS]]`
struct Arguments {
  Soup a, b;
  std::size_t least = 3;
  double budget = 1.0;
};

inline Arguments arguments(int count, char** values) {
  if (count < 3) throw std::runtime_error("usage: driver A.off B.off [LEAST [SECONDS]]");
  Arguments r;
  r.a = read_off(values[1]);
  r.b = read_off(values[2]);
  if (count > 3) r.least = std::stoul(values[3]);
  if (count > 4) r.budget = std::stod(values[4]);
  return r;
}
