package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.shell.MenuPlan.Entry;

final class MenuPlanTest {
  private final List<MenuPlan.Menu> menus = MenuPlan.of(List.of("run"), List.of("scene"));

  @Test
  void anActionIsWhereTheLongestStartOfItsIdIs() {
    assertEquals("editor.fold-all", placeOf("editor.fold-all"));
    assertEquals("editor.fold", placeOf("editor.fold"));
    assertEquals("debug", placeOf("debug.something-new"));
  }

  @Test
  void whatIsSeenOfSafetyHasAMenuOfItsOwn() {
    assertEquals("scene.safety", placeOf("scene.safety-planes"));
  }

  @Test
  void wordsOfIdsAreWhole() {
    assertEquals("file", placeOf("file.newest"));
  }

  @Test
  void whatNoMenuNamesIsInTheLastOne() {
    assertEquals("", placeOf("unheard.of"));
  }

  @Test
  void whatStandsForSeveralScreensIsNotListedAgain() {
    assertFalse(isPlaced("editor.undo"));
  }

  @Test
  void nodesToAddAndPlacesOfViewsAreNotListed() {
    assertFalse(isPlaced("tree.add-wait"));
    assertFalse(isPlaced("arrange.scene-right"));
  }

  private String placeOf(String id) {
    return MenuPlan.sorted(menus, List.of(id)).keySet().stream()
        .map(Entry.Rest::begin)
        .findFirst()
        .orElseThrow();
  }

  private boolean isPlaced(String id) {
    return !MenuPlan.sorted(menus, List.of(id)).isEmpty();
  }
}
