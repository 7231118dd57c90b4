package org.pendant.desktop.shell;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.dock.Side;
import org.pendant.kit.icon.Glyph;

/**
 * View places: the views of the window, and where each belongs at first.
 *
 * @param places screens first
 */
record ViewPlaces(List<Place> places) {
  /** Copies the list. */
  ViewPlaces {
    places = List.copyOf(places);
  }

  /**
   * A view and where it belongs at first.
   *
   * @param glyph of its button in the rail; empty for one that is only a panel
   */
  record Place(View view, Side home, Optional<Glyph> glyph) {}

  /** Those of {@code places}. */
  static ViewPlaces of(Place... places) {
    return new ViewPlaces(List.of(places));
  }

  /** That of a screen. */
  static Place screen(View view, Glyph glyph) {
    return new Place(new GuardedView(view), Side.MAIN, Optional.of(glyph));
  }

  /** That of a panel. */
  static Place panel(View view, Side home) {
    return new Place(new GuardedView(view), home, Optional.empty());
  }

  /** All views, screens first. */
  List<View> all() {
    return places.stream().map(Place::view).toList();
  }

  /** Whether people see the view of this id. */
  boolean showing(String id) {
    return places.stream()
        .map(Place::view)
        .anyMatch(view -> view.id().equals(id) && view.component().isShowing());
  }

  /** Where each belongs at first, by id. */
  Map<String, Side> home() {
    Map<String, Side> home = new LinkedHashMap<>();
    places.forEach(place -> home.put(place.view().id(), place.home()));
    return home;
  }

  /** The glyph of each screen, by id, in the order of the rail. */
  Map<String, Glyph> screens() {
    Map<String, Glyph> screens = new LinkedHashMap<>();
    places.forEach(
        place -> place.glyph().ifPresent(glyph -> screens.put(place.view().id(), glyph)));
    return screens;
  }
}
