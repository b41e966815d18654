// Operations of the CGAL drivers that insert curves one by one, keep their history, or walk along them.
#pragma once

#include <CGAL/Arrangement_with_history_2.h>
#include <CGAL/Object.h>

#include "curves.h"

template <class Model>
struct Edits : Operations<Model> {
  using Base = Operations<Model>;
  using typename Base::Arrangement;
  using typename Base::Traits;
  using Historic = CGAL::Arrangement_with_history_2<Traits>;

  static int files(const std::string& operation) {
    if (operation == "insert" || operation == "history" || operation == "insert-history") return 1;
    return operation == "zone" || operation == "zone-long" ? 2 : Base::files(operation);
  }

  void perform(const std::string& operation, const std::vector<Lines>& inputs) {
    if (operation == "insert") this->template insert<Arrangement>(inputs.at(0));
    else if (operation == "insert-history") this->template insert<Historic>(inputs.at(0));
    else if (operation == "history") history(inputs.at(0));
    else if (operation == "zone" || operation == "zone-long") zone(inputs.at(0), inputs.at(1));
    else Base::perform(operation, inputs);
  }

  // Aggregated insertion into an empty arrangement that remembers which curves its edges come from.
  void history(const Lines& input) {
    const auto all = this->curves(input);
    this->measure([&] { return this->template empty<Historic>(); },
                  [&](Historic& r) { CGAL::insert(r, all.begin(), all.end()); },
                  [&](const Historic& r) { this->count(r); });
  }

  // The cells that curves meet in an arrangement that is made before the clock starts. All curves are u-monotone.
  void zone(const Lines& input, const Lines& crossing) {
    const auto arrangement = this->made(input);
    using UMonotone = typename Traits::X_monotone_curve_2;
    std::vector<UMonotone> through;
    for (const auto& curve : this->curves(crossing)) through.emplace_back(curve);
    this->measure([] { return std::make_unique<std::vector<CGAL::Object>>(); },
                  [&](std::vector<CGAL::Object>& r) {
                    for (const auto& curve : through) CGAL::zone(*arrangement, curve, std::back_inserter(r));
                  },
                  [&](const std::vector<CGAL::Object>& r) {
                    for (const auto& cell : r) look_at_object(cell);
                  });
    this->answer.is_location = true;
    this->count(*arrangement);
  }

  void look_at_object(const CGAL::Object& cell) {
    using Place = boost::variant<typename Arrangement::Vertex_const_handle, typename Arrangement::Halfedge_const_handle,
                                 typename Arrangement::Face_const_handle>;
    typename Arrangement::Vertex_handle v;
    typename Arrangement::Halfedge_handle e;
    typename Arrangement::Face_handle f;
    if (CGAL::assign(v, cell)) this->look_at(Place(typename Arrangement::Vertex_const_handle(v)));
    else if (CGAL::assign(e, cell)) this->look_at(Place(typename Arrangement::Halfedge_const_handle(e)));
    else if (CGAL::assign(f, cell)) this->look_at(Place(typename Arrangement::Face_const_handle(f)));
    else throw std::runtime_error("a cell of no kind");
  }
};
