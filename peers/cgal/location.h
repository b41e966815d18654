// Operations of the CGAL drivers that find cells for points one by one, shoot rays, or decompose: over an arrangement that is made
// before the clock starts.
#pragma once

#include <CGAL/Arr_landmarks_point_location.h>
#include <CGAL/Arr_naive_point_location.h>
#include <CGAL/Arr_trapezoid_ric_point_location.h>
#include <CGAL/Arr_vertical_decomposition_2.h>
#include <CGAL/Arr_walk_along_line_point_location.h>

#include "edits.h"

template <class Model>
struct Location : Edits<Model> {
  using Base = Edits<Model>;
  using typename Base::Arrangement;
  using typename Base::Point;

  using Naive = CGAL::Arr_naive_point_location<Arrangement>;
  using Walk = CGAL::Arr_walk_along_line_point_location<Arrangement>;
  using Landmarks = CGAL::Arr_landmarks_point_location<Arrangement>;
  using Trapezoids = CGAL::Arr_trapezoid_ric_point_location<Arrangement>;

  static int files(const std::string& operation) {
    for (const char* one : {"make-landmarks", "make-trapezoids", "decompose"})
      if (operation == one) return 1;
    for (const char* two : {"naive", "walk", "landmarks", "trapezoids", "trapezoids-together", "ray"})
      if (operation == two) return 2;
    return Base::files(operation);
  }

  void perform(const std::string& operation, const std::vector<Lines>& inputs) {
    const auto locate = [](const auto& strategy, const Point& point) { return strategy.locate(point); };
    const auto shoot = [](const auto& strategy, const Point& point) { return strategy.ray_shoot_up(point); };
    if (operation == "make-landmarks") prepare<Landmarks>(inputs.at(0));
    else if (operation == "make-trapezoids") prepare<Trapezoids>(inputs.at(0));
    else if (operation == "naive") this->template ask<Naive>(inputs.at(0), inputs.at(1), locate);
    else if (operation == "walk") this->template ask<Walk>(inputs.at(0), inputs.at(1), locate);
    else if (operation == "landmarks") this->template ask<Landmarks>(inputs.at(0), inputs.at(1), locate);
    // It has no other way for points that are handed over together.
    else if (operation == "trapezoids" || operation == "trapezoids-together")
      this->template ask<Trapezoids>(inputs.at(0), inputs.at(1), locate);
    else if (operation == "ray") this->template ask<Trapezoids>(inputs.at(0), inputs.at(1), shoot);
    else if (operation == "decompose") decompose(inputs.at(0));
    else Base::perform(operation, inputs);
  }

  // What a strategy does before the first point.
  template <class Strategy>
  void prepare(const Lines& input) {
    const auto arrangement = this->made(input);
    this->measure([] { return std::make_unique<std::unique_ptr<Strategy>>(); },
                  [&](std::unique_ptr<Strategy>& r) { r = std::make_unique<Strategy>(*arrangement); },
                  [](const std::unique_ptr<Strategy>&) {});
    this->count(*arrangement);
  }

  // For each vertex what is straight below and above it. Where a vertical edge is, there is nothing.
  void decompose(const Lines& input) {
    using Vertex = typename Arrangement::Vertex_const_handle;
    using Entry = std::pair<Vertex, std::pair<CGAL::Object, CGAL::Object>>;
    const auto arrangement = this->made(input);
    this->measure([] { return std::make_unique<std::vector<Entry>>(); },
                  [&](std::vector<Entry>& r) { CGAL::decompose(*arrangement, std::back_inserter(r)); },
                  [&](const std::vector<Entry>& r) {
                    for (const auto& entry : r) look_at_wall(entry.second.first), look_at_wall(entry.second.second);
                  });
    this->answer.is_location = true;
    this->count(*arrangement);
  }

  void look_at_wall(const CGAL::Object& cell) {
    typename Arrangement::Vertex_const_handle v;
    typename Arrangement::Halfedge_const_handle e;
    typename Arrangement::Face_const_handle f;
    if (CGAL::assign(v, cell)) ++this->answer.on_vertices;
    else if (CGAL::assign(e, cell)) ++this->answer.on_edges;
    else if (CGAL::assign(f, cell)) ++this->answer.in_faces;
  }
};
