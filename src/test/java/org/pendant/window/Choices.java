package org.pendant.window;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/**
 * Chooses by names and numbers, which are the same in every language. Only the dispatch thread
 * calls it.
 */
final class Choices {
  private Choices() {}

  /** The items of the menu bar as they are now, by their names. */
  static Map<String, JMenuItem> items() {
    JFrame frame = (JFrame) Places.find("pendant");
    Map<String, JMenuItem> items = new LinkedHashMap<>();
    for (int i = 0; i < frame.getJMenuBar().getMenuCount(); i++) {
      JMenu menu = frame.getJMenuBar().getMenu(i);
      for (MenuListener each : menu.getMenuListeners()) {
        each.menuSelected(new MenuEvent(menu));
      }
      add(menu, items);
    }
    return items;
  }

  private static void add(JMenu menu, Map<String, JMenuItem> items) {
    for (int i = 0; i < menu.getItemCount(); i++) {
      switch (menu.getItem(i)) {
        case null -> {}
        case JMenu inner -> add(inner, items);
        case JMenuItem item -> items.put(String.valueOf(item.getName()), item);
      }
    }
  }

  /** Presses a visible button, or an item of the menu bar; what comes of it may last. */
  static String use(String name) {
    return use(name, Eyes.find(name).orElseGet(() -> items().get(name)));
  }

  /** {@code prefix=number}: one of the visible buttons whose names begin so. */
  static String useOf(String what) {
    String[] words = what.split("=", 2);
    return use(what, Eyes.beginning(words[0]).get(Integer.parseInt(words[1])));
  }

  private static String use(String name, Component component) {
    if (component instanceof AbstractButton button && button.isEnabled()) {
      EventQueue.invokeLater(() -> button.doClick(0));
      return "";
    }
    throw new IllegalArgumentException(name + " is not there or disabled");
  }

  /** How many rows, items or tabs there are to choose from. */
  static int count(Component component) {
    return switch (component) {
      case JList<?> list -> list.getModel().getSize();
      case JTree tree -> tree.getRowCount();
      case JTable table -> table.getRowCount();
      case JComboBox<?> box -> box.getItemCount();
      case JTabbedPane tabs -> tabs.getTabCount();
      default -> throw new IllegalArgumentException(component.getName() + " offers no choice");
    };
  }

  /** {@code name=number}. */
  static String select(String what) {
    String[] words = what.split("=", 2);
    int index = Integer.parseInt(words[1]);
    switch (Places.find(words[0])) {
      case JList<?> list -> list.setSelectedIndex(index);
      case JTree tree -> tree.setSelectionRow(index);
      case JTable table -> table.changeSelection(index, 0, false, false);
      case JComboBox<?> box -> box.setSelectedIndex(index);
      case JTabbedPane tabs -> tabs.setSelectedIndex(index);
      default -> throw new IllegalArgumentException(words[0] + " offers no choice");
    }
    return "";
  }
}
