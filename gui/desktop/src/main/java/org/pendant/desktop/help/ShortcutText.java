package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

import java.util.List;
import java.util.Map;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;

/** The keys that do actions now, as a page of the help. */
final class ShortcutText {
  private ShortcutText() {}

  /**
   * The page.
   *
   * @param groups the actions by where they stand, as ids; in its order
   */
  static String of(ActionTable actions, Map<String, List<String>> groups) {
    StringBuilder text = new StringBuilder("# " + text("keyboardShortcuts") + "\n\n");
    text.append(text("changeKeysInTheMenuHelp")).append("\n");
    groups.forEach(
        (title, ids) -> {
          List<Action> withKeys =
              ids.stream()
                  .flatMap(id -> actions.find(id).stream())
                  .filter(each -> !actions.keysOf(each.id()).isEmpty())
                  .toList();
          if (!withKeys.isEmpty()) {
            text.append("\n## ").append(title).append("\n\n");
            text.append("| ").append(text("keysOfTheTable"));
            text.append(" | ").append(text("actionOfTheTable")).append(" |\n| --- | --- |\n");
            // One key may do the same on several screens.
            withKeys.stream().map(each -> row(actions, each)).distinct().forEach(text::append);
          }
        });
    return text.toString();
  }

  private static String row(ActionTable actions, Action action) {
    String keys = KeyText.shown(actions.keysOf(action.id()));
    return "| **" + plain(keys) + "** | " + plain(action.title()) + " |\n";
  }

  /** Signs that mean something in Markdown mean themselves. */
  private static String plain(String text) {
    return text.replaceAll("[\\\\|*_`\\[\\]<>&]", "\\\\$0");
  }
}
