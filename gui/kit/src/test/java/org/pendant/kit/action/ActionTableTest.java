package org.pendant.kit.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

final class ActionTableTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings = new MemorySettings(remembered);
  private final ActionTable actions = new ActionTable(settings);
  private final List<String> done = new ArrayList<>();
  private boolean enabled = true;

  private void add(String id, String keys) {
    actions.add(new Action(id, id, keys, () -> enabled, () -> done.add(id)), () -> "not now");
  }

  @Test
  void anActionIsDoneOnlyWhileItIsEnabled() {
    add("a", "F5");
    actions.run("a");
    enabled = false;
    actions.run("a");
    actions.run("unknown");
    assertEquals(List.of("a"), done);
    assertEquals("not now", actions.reason("a"));
  }

  @Test
  void peoplesKeysComeFirstAndAreRemembered() {
    add("a", "F5");
    actions.rebind("a", "control shift X");
    assertEquals("control shift X", actions.keysOf("a"));
    assertTrue(actions.rebound("a"));
    ActionTable next = new ActionTable(settings);
    next.add(Action.of("a", "a", "F5", () -> {}));
    assertEquals(KeyStroke.getKeyStroke("control shift X"), next.strokeOf("a").orElseThrow());
    next.reset("a");
    assertEquals("F5", next.keysOf("a"));
    assertFalse(next.rebound("a"));
  }

  @Test
  void aKeyCanBeTakenAway() {
    add("a", "F5");
    actions.rebind("a", "");
    assertEquals("", actions.keysOf("a"));
    assertEquals(Optional.empty(), actions.strokeOf("a"));
  }

  @Test
  void sharedKeysAreConflicts() {
    add("a", "F5");
    add("b", "");
    add("c", "F6");
    actions.rebind("b", "F5");
    assertEquals(List.of("a"), actions.conflicts("b", "F5").stream().map(Action::id).toList());
    assertEquals(List.of(), actions.conflicts("c", "F6"));
  }

  @Test
  void keysInSettingsThatAreNoneAreIgnored() {
    remembered.put("key.a", "complete nonsense");
    add("a", "F5");
    assertEquals("F5", actions.keysOf("a"));
  }

  @Test
  void aKeyThatWasResetFollowsTheAction() {
    add("a", "control P");
    actions.rebind("a", "F5");
    actions.reset("a");
    ActionTable mac = new ActionTable(settings, KeyStyle.MAC);
    mac.add(Action.of("a", "a", "control P", () -> {}));
    assertEquals(KeyStroke.getKeyStroke("meta P"), mac.strokeOf("a").orElseThrow());
    assertFalse(mac.rebound("a"));
  }

  @Test
  void macosHasItsOwnKeyOfMenus() {
    assertEquals("meta P", KeyStyle.MAC.keys("control P"));
    assertEquals("shift meta P", KeyStyle.MAC.keys("control shift P"));
    assertEquals("control SPACE", KeyStyle.MAC.keys("control SPACE"));
    assertEquals("F5", KeyStyle.MAC.keys("F5"));
    assertEquals("control P", KeyStyle.PC.keys("control P"));
    assertEquals("\u21e7\u2318P", KeyStyle.MAC.shown(KeyStroke.getKeyStroke("shift meta P")));
    assertEquals(KeyStyle.MAC, KeyStyle.of("Mac OS X"));
    assertEquals(KeyStyle.PC, KeyStyle.of("Linux"));
  }

  @Test
  void keysThatAreNeededForWritingDoNoAction() {
    assertTrue(KeyText.bindable(KeyStroke.getKeyStroke("F5")));
    assertTrue(KeyText.bindable(KeyStroke.getKeyStroke("shift F5")));
    assertTrue(KeyText.bindable(KeyStroke.getKeyStroke("control A")));
    assertFalse(KeyText.bindable(KeyStroke.getKeyStroke("A")));
    assertFalse(KeyText.bindable(KeyStroke.getKeyStroke("shift A")));
    assertFalse(KeyText.bindable(KeyStroke.getKeyStroke("ENTER")));
    assertFalse(KeyText.bindable(KeyStroke.getKeyStroke("TAB")));
  }

  @Test
  void mistakesAreRefused() {
    add("a", "");
    assertEquals(
        "there is an action a already",
        assertThrows(IllegalArgumentException.class, () -> add("a", "")).getMessage());
    assertEquals(
        "keys of b are 'ctl P', expected such as control P",
        assertThrows(IllegalArgumentException.class, () -> add("b", "ctl P")).getMessage());
    assertThrows(IllegalArgumentException.class, () -> actions.rebind("a", "ctl P"));
  }

  @Test
  void keysAreShownAsOnAKeyboard() {
    assertEquals("Ctrl+Shift+P", KeyText.shown("control shift P"));
    assertEquals("Alt+1", KeyText.shown("alt 1"));
    assertEquals("Shift+F5", KeyText.shown("shift F5"));
    assertEquals("Ctrl+Page up", KeyText.shown("control PAGE_UP"));
    assertEquals("", KeyText.shown(""));
    KeyStroke stroke = KeyStroke.getKeyStroke("control alt DOWN");
    assertEquals(stroke, KeyStroke.getKeyStroke(KeyText.keys(stroke)));
  }

  @Test
  void actionsOfDifferentScreensMayHaveTheSameKey() {
    actions.setScreens(List.of("editor", "tree"));
    add("editor.undo", "control Z");
    add("tree.undo", "control Z");
    assertEquals(List.of(), actions.conflicts("tree.undo", "control Z"));
    add("run", "control Z");
    assertEquals(
        List.of("run"),
        actions.conflicts("tree.undo", "control Z").stream().map(Action::id).toList());
    assertEquals(2, actions.conflicts("run", "control Z").size());
  }
}
