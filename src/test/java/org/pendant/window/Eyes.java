package org.pendant.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.FocusTraversalPolicy;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.accessibility.AccessibleContext;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.ListCellRenderer;
import javax.swing.SwingUtilities;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;
import javax.swing.text.JTextComponent;

/** Finds what is visible and reads it. Only the dispatch thread calls it. */
final class Eyes {
  private Eyes() {}

  /** What is visible under {@code name}, in any window. */
  static Optional<Component> find(String name) {
    return Stream.of(Window.getWindows())
        .filter(Window::isShowing)
        .flatMap(Eyes::all)
        .filter(each -> name.equals(each.getName()) && each.isShowing())
        .findFirst();
  }

  /** Where the cell that reads {@code text} is on the screen. */
  static Optional<Rectangle> cell(JTable table, String text) {
    for (int row = 0; row < table.getRowCount(); row++) {
      for (int column = 0; column < table.getColumnCount(); column++) {
        if (cell(table, row, column).equals(text)) {
          Rectangle cell = table.getCellRect(row, column, false);
          Point corner = table.getLocationOnScreen();
          cell.translate(corner.x, corner.y);
          return Optional.of(cell);
        }
      }
    }
    return Optional.empty();
  }

  /** Whether keys go to {@code component} or to something in it. */
  static boolean focused(Component component) {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && SwingUtilities.isDescendingFrom(owner, component);
  }

  /** The button inside {@code component} that reads {@code text}. */
  static Optional<Component> inside(Component component, String text) {
    return all(component)
        .filter(each -> each instanceof AbstractButton button && text.equals(button.getText()))
        .filter(Component::isShowing)
        .findFirst();
  }

  private static Stream<Component> all(Component component) {
    return component instanceof Container container
        ? Stream.concat(
            Stream.of(component), Stream.of(container.getComponents()).flatMap(Eyes::all))
        : Stream.of(component);
  }

  /** The words that people read on a component and on what is in it, a line for each row. */
  static String words(Component component) {
    return switch (component) {
      case JTextComponent text -> text.getText();
      case JLabel label -> label.getText() == null ? "" : label.getText();
      case AbstractButton button -> button.getText();
      case JComboBox<?> box -> String.valueOf(box.getSelectedItem());
      case JTable table -> lines(table.getRowCount(), row -> row(table, row));
      case JList<?> list -> lines(list.getModel().getSize(), index -> item(list, index));
      case JTree tree -> lines(tree.getRowCount(), row -> node(tree, row));
      case Container container ->
          String.join(
              " ",
              Stream.of(container.getComponents())
                  .filter(Component::isVisible)
                  .map(Eyes::words)
                  .filter(words -> !words.isBlank())
                  .toList());
      default -> "";
    };
  }

  private static String lines(int count, IntFunction<String> line) {
    return String.join("\n", IntStream.range(0, count).mapToObj(line).toList());
  }

  private static String row(JTable table, int row) {
    List<String> cells = new ArrayList<>();
    for (int column = 0; column < table.getColumnCount(); column++) {
      cells.add(cell(table, row, column));
    }
    return String.join(" | ", cells);
  }

  private static String cell(JTable table, int row, int column) {
    return words(table.prepareRenderer(table.getCellRenderer(row, column), row, column));
  }

  /** The words of a row of a list. */
  static <T> String item(JList<T> list, int index) {
    ListCellRenderer<? super T> renderer = list.getCellRenderer();
    return words(
        renderer.getListCellRendererComponent(
            list, list.getModel().getElementAt(index), index, false, false));
  }

  /** The words of a row of a tree. */
  static String node(JTree tree, int row) {
    Object node = tree.getPathForRow(row).getLastPathComponent();
    return words(
        tree.getCellRenderer()
            .getTreeCellRendererComponent(tree, node, false, true, true, row, false));
  }

  /** Whether all of {@code component} can be seen. */
  static boolean whole(Component component) {
    Rectangle place = place(component);
    Window window = SwingUtilities.getWindowAncestor(component);
    return place.getSize().equals(component.getSize())
        && !place.isEmpty()
        && window.getBounds().contains(place);
  }

  /** The titles of tabs, a line each. */
  static String tabs(Component component) {
    if (component instanceof JTabbedPane tabs) {
      return lines(tabs.getTabCount(), tabs::getTitleAt);
    }
    throw new IllegalArgumentException(component.getName() + " has no tabs");
  }

  /** Where the tab that reads {@code title} is on the screen. */
  static Rectangle tab(Component component, String title) {
    if (component instanceof JTabbedPane tabs && tabs.indexOfTab(title) >= 0) {
      Rectangle tab = tabs.getBoundsAt(tabs.indexOfTab(title));
      Point corner = tabs.getLocationOnScreen();
      tab.translate(corner.x, corner.y);
      return tab;
    }
    throw new IllegalArgumentException(component.getName() + " has no tab " + title);
  }

  /** The names of what is visible in any window that begin with {@code prefix}, a line each. */
  static String named(String prefix) {
    return String.join("\n", beginning(prefix).stream().map(Component::getName).toList());
  }

  /** What is visible in any window whose name begins with {@code prefix}. */
  static List<Component> beginning(String prefix) {
    return Stream.of(Window.getWindows())
        .filter(Window::isShowing)
        .flatMap(Eyes::all)
        .filter(Component::isShowing)
        .filter(each -> each.getName() != null && each.getName().startsWith(prefix))
        .toList();
  }

  /** Every entry of every menu that is there, with the menus it is in, a line each. */
  static String menus(JFrame frame) {
    List<String> lines = new ArrayList<>();
    for (int i = 0; i < frame.getJMenuBar().getMenuCount(); i++) {
      JMenu menu = frame.getJMenuBar().getMenu(i);
      if (menu.isVisible()) {
        for (MenuListener each : menu.getMenuListeners()) {
          each.menuSelected(new MenuEvent(menu));
        }
        addMenu(menu, menu.getText(), lines);
      }
    }
    return String.join("\n", lines);
  }

  private static void addMenu(JMenu menu, String path, List<String> lines) {
    for (int i = 0; i < menu.getItemCount(); i++) {
      JMenuItem item = menu.getItem(i);
      if (item != null) {
        String name = path + " > " + item.getText();
        lines.add(name);
        if (item instanceof JMenu inner) {
          addMenu(inner, name, lines);
        }
      }
    }
  }

  /** What keys can reach in {@code component} and a screen reader has no name for. */
  static String nameless(Component component) {
    Container cycle =
        component instanceof Window window ? window : component.getFocusCycleRootAncestor();
    FocusTraversalPolicy policy = cycle.getFocusTraversalPolicy();
    List<Component> stops = new ArrayList<>();
    Component next = policy.getFirstComponent(cycle);
    while (next != null && !stops.contains(next)) {
      stops.add(next);
      next = policy.getComponentAfter(cycle, next);
    }
    return String.join("\n", stops.stream().filter(Eyes::withoutName).map(Eyes::path).toList());
  }

  private static boolean withoutName(Component component) {
    AccessibleContext context = component.getAccessibleContext();
    String name = context == null ? null : context.getAccessibleName();
    return name == null || name.isBlank();
  }

  private static String path(Component component) {
    String name = component.getName() == null ? "" : " " + component.getName();
    String self = component.getClass().getSimpleName() + name;
    return component.getParent() == null ? self : path(component.getParent()) + " / " + self;
  }

  /** Where the visible part of {@code component} is on the screen. */
  static Rectangle place(Component component) {
    Rectangle place =
        component instanceof JComponent inside
            ? inside.getVisibleRect()
            : new Rectangle(component.getSize());
    Point corner = component.getLocationOnScreen();
    place.translate(corner.x, corner.y);
    return place;
  }

  /** How many colours a picture has. */
  static long colours(BufferedImage picture) {
    return pixels(picture).distinct().count();
  }

  /** Mean brightness of a picture, 0 to 255. */
  static long brightness(BufferedImage picture) {
    return Math.round(
        pixels(picture)
            .map(rgb -> ((rgb >> 16 & 255) + (rgb >> 8 & 255) + (rgb & 255)) / 3)
            .average()
            .orElse(0));
  }

  private static IntStream pixels(BufferedImage picture) {
    int width = picture.getWidth();
    return IntStream.of(picture.getRGB(0, 0, width, picture.getHeight(), null, 0, width));
  }
}
