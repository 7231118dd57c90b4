package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;

/** Log menus: the menus of the log: of a message, and of the columns. */
final class LogMenus {
  private final LogColumns columns;
  private final Runnable changed;

  /**
   * Menus.
   *
   * @param changed runs after other columns have been chosen
   */
  LogMenus(LogColumns columns, Runnable changed) {
    this.columns = columns;
    this.changed = changed;
  }

  /** What can be done with a message. */
  JPopupMenu ofMessages(Runnable copy, Runnable showSource) {
    JPopupMenu menu = new JPopupMenu();
    menu.add(item(text("copy"), "log-menu-copy", copy));
    menu.add(item(text("showThePlaceInTheProgram"), "log-menu-source", showSource));
    JMenu shown = new JMenu(text("columns"));
    fill(shown::add);
    menu.addSeparator();
    menu.add(shown);
    return menu;
  }

  /** Which columns there are. */
  JPopupMenu ofColumns() {
    JPopupMenu menu = new JPopupMenu();
    fill(menu::add);
    return menu;
  }

  private void fill(Consumer<JMenuItem> add) {
    for (LogColumn each : LogColumn.values()) {
      if (each.optional()) {
        JCheckBoxMenuItem item = new JCheckBoxMenuItem(each.title());
        item.setName("log-column-" + each.name().toLowerCase(Locale.ROOT));
        item.setToolTipText(each.meaning());
        item.setModel(new Wanted(each));
        item.addActionListener(
            event -> {
              columns.want(each, !columns.wanted(each));
              changed.run();
            });
        add.accept(item);
      }
    }
  }

  private static JMenuItem item(String text, String name, Runnable run) {
    JMenuItem item = new JMenuItem(text);
    item.setName(name);
    item.addActionListener(event -> run.run());
    return item;
  }

  /** Checked as long as the column is wanted, whichever menu changed it. */
  @SuppressWarnings("serial") // never written to a stream
  private final class Wanted extends javax.swing.DefaultButtonModel {
    private final LogColumn column;

    Wanted(LogColumn column) {
      this.column = column;
    }

    @Override
    public boolean isSelected() {
      return columns.wanted(column);
    }
  }
}
