package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JRadioButtonMenuItem;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.kit.action.ActionItem;
import org.pendant.kit.action.ActionTable;

/**
 * Program menu: programs that are open, those that were open lately, and what can be done with
 * files.
 *
 * @param recent files that were open lately, the last one first
 * @param open opens a file
 */
public record ProgramMenu(
    ActionTable actions, Programs programs, Supplier<List<Path>> recent, Consumer<Path> open) {
  private static final List<String> FILES =
      List.of("file.new", "file.open", "file.save", "file.save-as");

  /** The menu as things are now. */
  JPopupMenu popup() {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("program-menu");
    for (ProgramDocument each : programs.all()) {
      JMenuItem item = new JRadioButtonMenuItem(name(each), each == programs.current());
      item.setToolTipText(each.file().map(Object::toString).orElse(text("notSavedYet")));
      item.addActionListener(event -> programs.select(each));
      menu.add(item);
    }
    List<Path> others = recent.get().stream().filter(each -> programs.of(each).isEmpty()).toList();
    if (!others.isEmpty()) {
      menu.addSeparator();
      others.forEach(each -> menu.add(recentItem(each, open)));
    }
    menu.addSeparator();
    FILES.forEach(id -> menu.add(ActionItem.of(actions, id)));
    return menu;
  }

  private static String name(ProgramDocument document) {
    return document.name() + (document.modified() ? " \u2022" : "");
  }

  /** The name of a file and, after it, its folder. */
  public static JMenuItem recentItem(Path file, Consumer<Path> open) {
    Path folder = file.toAbsolutePath().getParent();
    JMenuItem item =
        new JMenuItem(shortened(file.getFileName() + (folder == null ? "" : "  in " + folder)));
    item.setToolTipText(file.toString());
    item.addActionListener(event -> open.accept(file));
    return item;
  }

  /** Menus have no room for every path: the middle is the least telling part. */
  static String shortened(String text) {
    int most = 80;
    int half = most / 2 - 1;
    return text.length() <= most
        ? text
        : text.substring(0, half) + "\u2026" + text.substring(text.length() - half);
  }
}
