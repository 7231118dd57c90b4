package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

final class DockPlanTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings = new MemorySettings(remembered);

  private static Map<String, Side> home() {
    Map<String, Side> home = new LinkedHashMap<>();
    home.put("run", Side.MAIN);
    home.put("log", Side.MAIN);
    home.put("scene", Side.RIGHT);
    home.put("variables", Side.RIGHT);
    home.put("problems", Side.BOTTOM);
    return home;
  }

  private DockPlan plan() {
    return new DockPlan(settings, home(), Set.of("run"));
  }

  @Test
  void viewsAreAtHomeAtFirst() {
    assertEquals(List.of("run", "log"), plan().views(Side.MAIN));
    assertEquals(Optional.of("scene"), plan().selected(Side.RIGHT));
    assertTrue(plan().collapsed(Side.BOTTOM));
  }

  @Test
  void whatIsMovedIsInFrontThereNowAndNextTime() {
    plan().move("log", Side.BOTTOM);
    DockPlan next = plan();
    assertEquals(List.of("run"), next.views(Side.MAIN));
    assertEquals(List.of("problems", "log"), next.views(Side.BOTTOM));
    assertEquals(Optional.of("log"), next.selected(Side.BOTTOM));
    assertFalse(next.collapsed(Side.BOTTOM));
  }

  @Test
  void aViewGoesWhereItsTabIsDropped() {
    DockPlan plan = plan();
    plan.move("variables", Side.RIGHT, 0);
    assertEquals(List.of("variables", "scene"), plan().views(Side.RIGHT));
    plan.move("problems", Side.RIGHT, 1);
    assertEquals(List.of("variables", "problems", "scene"), plan().views(Side.RIGHT));
    plan.move("variables", Side.RIGHT, 99);
    assertEquals(List.of("problems", "scene", "variables"), plan().views(Side.RIGHT));
  }

  @Test
  void aViewInAWindowOfItsOwnIsThereNextTimeAndGoesBackToWhereItWas() {
    DockPlan plan = plan();
    plan.move("variables", Side.BOTTOM);
    plan.move("variables", Side.WINDOW);
    plan.setWindowBounds("variables", new Rectangle(10, 20, 300, 200));
    DockPlan next = plan();
    assertEquals(List.of("variables"), next.views(Side.WINDOW));
    assertEquals(Optional.of(new Rectangle(10, 20, 300, 200)), next.windowBounds("variables"));
    next.putBack("variables");
    assertEquals(List.of("problems", "variables"), next.views(Side.BOTTOM));
    assertFalse(next.collapsed(Side.BOTTOM));
  }

  @Test
  void aScreenInAWindowOfItsOwnLeavesTheMainAreaToTheOthers() {
    DockPlan plan = plan();
    plan.select("log");
    plan.move("log", Side.WINDOW);
    plan.select("log");
    assertEquals(Optional.of("run"), plan().selected(Side.MAIN));
  }

  @Test
  void anEmptySideStaysEmpty() {
    DockPlan plan = plan();
    plan.move("scene", Side.LEFT);
    plan.move("variables", Side.LEFT);
    assertEquals(List.of(), plan().views(Side.RIGHT));
    assertEquals(Optional.empty(), plan().selected(Side.RIGHT));
  }

  @Test
  void unknownAndDoubleNamesInSettingsAreLeftOutAndNewViewsAreAtHome() {
    remembered.put("dock.left.views", "scene gone scene");
    remembered.put("dock.bottom.views", "scene");
    remembered.put("dock.run.right.share", "wide");
    DockPlan plan = plan();
    assertEquals(List.of("scene"), plan.views(Side.LEFT));
    assertEquals(List.of("variables"), plan.views(Side.RIGHT));
    assertEquals(List.of("problems"), plan.views(Side.BOTTOM));
    assertEquals(0.46, plan.share(Side.RIGHT));
  }

  @Test
  void sizesAreRememberedWithinReason() {
    DockPlan plan = plan();
    plan.setShare(Side.RIGHT, 0.412);
    plan.setShare(Side.BOTTOM, -5);
    assertEquals(0.412, plan().share(Side.RIGHT));
    assertEquals(0.05, plan().share(Side.BOTTOM));
  }

  @Test
  void eachScreenRemembersItsSizesItsFrontTabsAndWhatIsFolded() {
    DockPlan plan = plan();
    plan.select("variables");
    plan.setShare(Side.RIGHT, 0.6);
    plan.setCollapsed(Side.BOTTOM, false);
    plan.select("log");
    assertEquals(Optional.of("scene"), plan.selected(Side.RIGHT));
    assertEquals(0.34, plan.share(Side.RIGHT));
    assertTrue(plan.collapsed(Side.BOTTOM));
    DockPlan next = plan();
    assertEquals(Optional.of("log"), next.selected(Side.MAIN));
    next.select("run");
    assertEquals(Optional.of("variables"), next.selected(Side.RIGHT));
    assertEquals(0.6, next.share(Side.RIGHT));
    assertFalse(next.collapsed(Side.BOTTOM));
  }

  @Test
  void screensToLookAtTheArmHaveWiderDocksAtTheRight() {
    DockPlan plan = plan();
    assertEquals(0.46, plan.share(Side.RIGHT));
    plan.select("log");
    assertEquals(0.34, plan.share(Side.RIGHT));
  }

  @Test
  void theLowerRightIsFoldedAndUnfoldedWithTheOneAbove() {
    DockPlan plan = plan();
    plan.move("variables", Side.LOWER);
    plan.setCollapsed(Side.RIGHT, true);
    assertTrue(plan.collapsed(Side.LOWER));
    plan.setCollapsed(Side.LOWER, false);
    assertFalse(plan.collapsed(Side.RIGHT));
    plan.setCollapsed(Side.LOWER, true);
    assertFalse(plan.collapsed(Side.RIGHT));
  }

  @Test
  void theMainAreaIsNeverCollapsed() {
    DockPlan plan = plan();
    plan.setCollapsed(Side.MAIN, true);
    assertFalse(plan.collapsed(Side.MAIN));
  }

  @Test
  void everythingGoesHomeOnRequest() {
    DockPlan plan = plan();
    plan.move("run", Side.LEFT);
    plan.setShare(Side.RIGHT, 0.6);
    plan.reset(home());
    assertEquals(List.of("run", "log"), plan().views(Side.MAIN));
    assertEquals(0.46, plan().share(Side.RIGHT));
  }
}
