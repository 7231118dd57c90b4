package org.pendant.gui.workbench;

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

final class ActionTableTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final Settings settings =
      new Settings() {
        @Override
        public Optional<String> get(String name) {
          return Optional.ofNullable(remembered.get(name));
        }

        @Override
        public void put(String name, String text) {
          remembered.put(name, text);
        }
      };
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
}
