package org.pendant.desktop.help;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;

final class ShortcutTextTest {
  /** Remembers nothing. */
  @Test
  void sheetHasTheActionsThatHaveKeysUnderTheirMenus() {
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("program.run", "Run program", "F5", () -> {}));
    actions.add(Action.of("program.other", "Something else", "", () -> {}));
    String text =
        ShortcutText.of(
            actions, Map.of("Program", List.of("program.run", "program.other"), "Go", List.of()));
    assertTrue(text.contains("## Program\n\n| Keys | Action |"), text);
    assertTrue(text.contains("\n| **F5** | Run program |\n"), text);
    assertFalse(text.contains("Something else"), text);
    assertFalse(text.contains("## Go"), text);
  }

  @Test
  void aKeyThatDoesTheSameOnTwoScreensHasOneRow() {
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("editor.close", "Close program", "control W", () -> {}));
    actions.add(Action.of("tree.close", "Close program", "control W", () -> {}));
    String text = ShortcutText.of(actions, Map.of("File", List.of("editor.close", "tree.close")));
    assertEquals(2, text.split("Close program", -1).length, text);
  }

  @Test
  void signsOfKeysAndTitlesMeanNothingElse() {
    ActionTable actions = new ActionTable(new MemorySettings());
    actions.add(Action.of("view.bottom", "Show *all* of a|b", "control BACK_SLASH", () -> {}));
    String html = Markdown.html(ShortcutText.of(actions, Map.of("View", List.of("view.bottom"))));
    assertTrue(html.contains("<strong>Ctrl+\\</strong>"), html);
    assertTrue(html.contains(">Show *all* of a|b<"), html);
  }
}
