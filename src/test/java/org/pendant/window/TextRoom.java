package org.pendant.window;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.ListCellRenderer;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;
import javax.swing.table.JTableHeader;
import javax.swing.text.View;

/**
 * Whether texts have the room that they need. A text is told of that is cut or covered, unless its
 * tool tip has all of it; so is a tool tip that is wider than the window. Only the dispatch thread
 * calls it.
 */
final class TextRoom {
  /** Who rounds up to whole pixels may be off by one. */
  private static final int TOLERANCE_PX = 1;

  /** Rows of lists, tables and trees below these are like those above. */
  private static final int MAX_ROWS = 60;

  /** Cells that draw their text themselves, and break its lines or tell all of it in a tool tip. */
  private static final Set<String> BREAKING = Set.of("TreeCell", "MessageCell");

  /** The smallest window that everything has to fit into. */
  private static final Dimension SMALL = new Dimension(1024, 700);

  private final Set<String> texts = new LinkedHashSet<>();
  private final Set<Component> components = new LinkedHashSet<>();
  private List<String> cut = new ArrayList<>();

  /** What has too little room in any window now, a line each. */
  String look() {
    cut = new ArrayList<>();
    Stream.of(Window.getWindows()).filter(Window::isShowing).forEach(this::look);
    return String.join("\n", new LinkedHashSet<>(cut));
  }

  /** How many components with texts, and how many different texts, were looked at. */
  String count() {
    return components.size() + " components, " + texts.size() + " texts";
  }

  /** Menus that are larger than the window, with the menus in them. */
  String menus(JFrame frame) {
    cut = new ArrayList<>();
    for (int i = 0; i < frame.getJMenuBar().getMenuCount(); i++) {
      menu(frame.getJMenuBar().getMenu(i));
    }
    return String.join("\n", cut);
  }

  private void menu(JMenu menu) {
    Dimension size = menu.getPopupMenu().getPreferredSize();
    if (size.width > SMALL.width / 2 || size.height > SMALL.height) {
      report(menu, menu.getText(), "is a menu of " + size.width + " x " + size.height);
    }
    for (int i = 0; i < menu.getItemCount(); i++) {
      JMenuItem item = menu.getItem(i);
      if (item != null) {
        note(item, item.getText());
        toolTip(item);
      }
      if (item instanceof JMenu inner) {
        menu(inner);
      }
    }
  }

  private void look(Component component) {
    if (!component.isShowing()) {
      return;
    }
    text(component, "");
    if (component instanceof JComponent inside) {
      toolTip(inside);
    }
    if (component instanceof Container container && !(component instanceof JComboBox<?>)) {
      for (Component each : container.getComponents()) {
        look(each);
      }
    }
  }

  /**
   * What a component reads by itself.
   *
   * @param tip a tool tip that is shown for it, beside its own
   */
  private void text(Component component, String tip) {
    switch (component) {
      case JLabel label when BREAKING.contains(label.getClass().getSimpleName()) -> {}
      case JLabel label -> label(label, tip);
      case JMenuItem item -> whole(item, item.getText(), item.getPreferredSize(), tip);
      case AbstractButton button -> button(button, tip);
      case JComboBox<?> box -> items(box);
      case JTabbedPane tabs -> tabs(tabs);
      case JTable table -> table(table);
      case JTableHeader header -> header(header);
      case JList<?> list -> list(list);
      case JTree tree -> tree(tree);
      case JTextField field -> field(field, tip);
      case JTextArea area -> area(area, tip);
      default -> {}
    }
  }

  private void label(JLabel label, String tip) {
    String text = label.getText();
    if (ToolTips.blank(text)) {
      return;
    }
    note(label, text);
    Rectangle inner = inner(label);
    View html = (View) label.getClientProperty("html");
    if (html == null) {
      compound(
          label,
          text,
          label.getIcon(),
          label.getIconTextGap(),
          new int[] {
            label.getVerticalAlignment(),
            label.getHorizontalAlignment(),
            label.getVerticalTextPosition(),
            label.getHorizontalTextPosition()
          },
          inner,
          tip);
      return;
    }
    int icon =
        label.getIcon() == null ? 0 : label.getIcon().getIconWidth() + label.getIconTextGap();
    int width = inner.width - icon;
    html.setSize(width, inner.height);
    if (html.getMinimumSpan(View.X_AXIS) > width + TOLERANCE_PX) {
      cut(label, text, "needs " + (int) html.getMinimumSpan(View.X_AXIS) + " of " + width, tip);
    } else if (html.getPreferredSpan(View.Y_AXIS) > inner.height + TOLERANCE_PX) {
      cut(
          label,
          text,
          "is " + (int) html.getPreferredSpan(View.Y_AXIS) + " high of " + inner.height,
          tip);
    } else {
      covered(label, text, tip);
    }
  }

  private void button(AbstractButton button, String tip) {
    String text = button.getText();
    if (ToolTips.blank(text)) {
      return;
    }
    note(button, text);
    if (button.getPreferredSize().width <= button.getWidth()
        || button.getClientProperty("html") != null) {
      whole(button, text, button.getPreferredSize(), tip);
      return;
    }
    compound(
        button,
        text,
        button.getIcon(),
        button.getIconTextGap(),
        new int[] {
          button.getVerticalAlignment(),
          button.getHorizontalAlignment(),
          button.getVerticalTextPosition(),
          button.getHorizontalTextPosition()
        },
        inner(button),
        tip);
  }

  private void compound(
      JComponent component,
      String text,
      Icon icon,
      int gap,
      int[] alignment,
      Rectangle inner,
      String tip) {
    FontMetrics metrics = component.getFontMetrics(component.getFont());
    String shown =
        SwingUtilities.layoutCompoundLabel(
            component,
            metrics,
            text,
            icon,
            alignment[0],
            alignment[1],
            alignment[2],
            alignment[3],
            inner,
            new Rectangle(),
            new Rectangle(),
            gap);
    if (!shown.equals(text) && metrics.stringWidth(text) > 0) {
      cut(
          component,
          text,
          "needs " + metrics.stringWidth(text) + " of " + inner.width + ": " + shown,
          tip);
    } else if (metrics.getAscent() > inner.height) {
      cut(component, text, "has a height of " + inner.height, tip);
    } else {
      covered(component, text, tip);
    }
  }

  private void whole(Component component, String text, Dimension wanted, String tip) {
    if (ToolTips.blank(text)) {
      return;
    }
    note(component, text);
    if (wanted.width > component.getWidth() + TOLERANCE_PX) {
      cut(component, text, "needs " + wanted.width + " of " + component.getWidth(), tip);
    } else {
      covered(component, text, tip);
    }
  }

  private <T> void items(JComboBox<T> box) {
    if (box.isEditable() || box.getSelectedIndex() < 0) {
      return;
    }
    covered(box, String.valueOf(box.getSelectedItem()), "");
    int arrow =
        Stream.of(box.getComponents())
            .filter(AbstractButton.class::isInstance)
            .mapToInt(Component::getWidth)
            .sum();
    Insets insets = box.getInsets();
    int room = box.getWidth() - arrow - insets.left - insets.right;
    ListCellRenderer<? super T> renderer = box.getRenderer();
    JList<T> list = new JList<>(box.getModel());
    list.setFont(box.getFont());
    String chosen =
        Eyes.words(
            renderer.getListCellRendererComponent(
                list, box.getItemAt(box.getSelectedIndex()), -1, false, false));
    for (int i = 0; i < Math.min(box.getItemCount(), MAX_ROWS); i++) {
      Component item =
          renderer.getListCellRendererComponent(list, box.getItemAt(i), -1, false, false);
      String text = Eyes.words(item);
      note(box, text);
      // its tool tip has the item that is chosen
      if (item.getPreferredSize().width > room + TOLERANCE_PX
          && !ToolTips.tells(box.getToolTipText(), chosen)) {
        cut(box, text, "needs " + item.getPreferredSize().width + " of " + room, "");
      }
    }
  }

  private void tabs(JTabbedPane tabs) {
    for (int i = 0; i < tabs.getTabCount(); i++) {
      String title = tabs.getTitleAt(i);
      Rectangle tab = tabs.getBoundsAt(i);
      if (ToolTips.blank(title) || tab == null || tabs.getTabComponentAt(i) != null) {
        continue;
      }
      note(tabs, title);
      int wanted = tabs.getFontMetrics(tabs.getFont()).stringWidth(title);
      String tip = tabs.getToolTipTextAt(i);
      if (wanted > tab.width) {
        cut(tabs, title, "needs " + wanted + " of " + tab.width, tip == null ? "" : tip);
      }
    }
  }

  private void table(JTable table) {
    Rectangle seen = table.getVisibleRect();
    for (int row = 0; row < Math.min(table.getRowCount(), MAX_ROWS); row++) {
      for (int column = 0; column < table.getColumnCount(); column++) {
        Rectangle cell = table.getCellRect(row, column, false);
        if (seen.intersects(cell)) {
          drawn(
              table,
              table.prepareRenderer(table.getCellRenderer(row, column), row, column),
              cell,
              table.getToolTipText(ToolTips.pointing(table, cell)));
        }
      }
    }
  }

  private void header(JTableHeader header) {
    for (int i = 0; i < header.getColumnModel().getColumnCount(); i++) {
      Rectangle cell = header.getHeaderRect(i);
      var column = header.getColumnModel().getColumn(i);
      var renderer =
          column.getHeaderRenderer() == null
              ? header.getDefaultRenderer()
              : column.getHeaderRenderer();
      Component title =
          renderer.getTableCellRendererComponent(
              header.getTable(), column.getHeaderValue(), false, false, -1, i);
      drawn(header, title, cell, header.getToolTipText(ToolTips.pointing(header, cell)));
    }
  }

  private <T> void list(JList<T> list) {
    for (int i = 0; i < Math.min(list.getModel().getSize(), MAX_ROWS); i++) {
      Rectangle cell = list.getCellBounds(i, i);
      if (cell != null && list.getVisibleRect().intersects(cell)) {
        Component item =
            list.getCellRenderer()
                .getListCellRendererComponent(
                    list, list.getModel().getElementAt(i), i, false, false);
        drawn(list, item, cell, list.getToolTipText(ToolTips.pointing(list, cell)));
      }
    }
  }

  private void tree(JTree tree) {
    for (int row = 0; row < Math.min(tree.getRowCount(), MAX_ROWS); row++) {
      Rectangle place = tree.getRowBounds(row);
      Object node = tree.getPathForRow(row).getLastPathComponent();
      Component cell =
          tree.getCellRenderer()
              .getTreeCellRendererComponent(tree, node, false, true, true, row, false);
      if (tree.getVisibleRect().intersects(place)) {
        drawn(tree, cell, place, tree.getToolTipText(ToolTips.pointing(tree, place)));
      }
    }
  }

  /** A component that only draws a row or a cell, at the size that it is drawn with. */
  private void drawn(JComponent owner, Component cell, Rectangle place, String tip) {
    cell.setSize(place.width, place.height);
    layOut(cell);
    drawn(owner, cell, tip == null ? "" : tip);
  }

  private void drawn(JComponent owner, Component cell, String tip) {
    int before = cut.size();
    text(cell, tip);
    for (int i = before; i < cut.size(); i++) {
      cut.set(i, path(owner) + " > " + cut.get(i));
    }
    if (cell instanceof Container container) {
      for (Component each : container.getComponents()) {
        if (each.isVisible()) {
          drawn(owner, each, tip);
        }
      }
    }
  }

  private static void layOut(Component component) {
    if (component instanceof Container container) {
      container.invalidate(); // or it stays laid out for the cell before
      container.doLayout();
      for (Component each : container.getComponents()) {
        layOut(each);
      }
    }
  }

  private void field(JTextField field, String tip) {
    Object hint = field.getClientProperty("JTextField.placeholderText");
    String text = field.getText().isEmpty() && hint != null ? hint.toString() : field.getText();
    if (ToolTips.blank(text)) {
      return;
    }
    note(field, text);
    int wanted = field.getFontMetrics(field.getFont()).stringWidth(text);
    Rectangle inner = inner(field);
    boolean typed = !field.getText().isEmpty() && !text.matches("[-+.0-9 ]*");
    if (wanted > inner.width && !typed) {
      cut(field, text, "needs " + wanted + " of " + inner.width, tip);
    } else {
      covered(field, text, tip);
    }
  }

  private void area(JTextArea area, String tip) {
    if (ToolTips.blank(area.getText()) || area.getParent() instanceof JViewport) {
      return;
    }
    note(area, area.getText());
    Dimension wanted = area.getPreferredSize();
    if (wanted.height > area.getHeight() + TOLERANCE_PX) {
      cut(area, area.getText(), "is " + wanted.height + " high of " + area.getHeight(), tip);
    } else if (!area.getLineWrap() && wanted.width > area.getWidth() + TOLERANCE_PX) {
      cut(area, area.getText(), "needs " + wanted.width + " of " + area.getWidth(), tip);
    } else {
      covered(area, area.getText(), tip);
    }
  }

  private void toolTip(JComponent component) {
    String tip = component.getToolTipText();
    if (tip == null || tip.startsWith("<html>")) {
      return;
    }
    int width = component.getFontMetrics(component.getFont()).stringWidth(tip);
    if (width > SMALL.width) {
      report(component, tip, "is a tool tip of " + width);
    }
  }

  /** Tells of a text that lies outside of what is around it, where nobody can scroll to it. */
  private void covered(Component component, String text, String tip) {
    Rectangle place = component.getBounds();
    for (Container parent = component.getParent();
        parent != null && component.isShowing();
        parent = parent.getParent()) {
      Rectangle free = new Rectangle(parent.getSize());
      if (parent instanceof JViewport port) {
        place = scrolled(port, place);
      }
      if (place.x < -TOLERANCE_PX || place.x + place.width > free.width + TOLERANCE_PX) {
        String where = place.x + " + " + place.width + " of " + free.width;
        cut(component, text, "is beside " + path(parent) + ": " + where, tip);
        return;
      }
      if (place.y < -TOLERANCE_PX || place.y + place.height > free.height + TOLERANCE_PX) {
        String where = place.y + " + " + place.height + " of " + free.height;
        cut(component, text, "is below " + path(parent) + ": " + where, tip);
        return;
      }
      if (parent instanceof Window) {
        return;
      }
      place.translate(parent.getX(), parent.getY());
    }
  }

  /** The place as people can see it after they have scrolled to it. */
  private static Rectangle scrolled(JViewport port, Rectangle place) {
    Rectangle seen = new Rectangle(place);
    if (port.getParent() instanceof JScrollPane pane) {
      if (pane.getHorizontalScrollBarPolicy() != ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER) {
        seen.x = 0;
        seen.width = Math.min(seen.width, port.getWidth());
      }
      if (pane.getVerticalScrollBarPolicy() != ScrollPaneConstants.VERTICAL_SCROLLBAR_NEVER) {
        seen.y = 0;
        seen.height = Math.min(seen.height, port.getHeight());
      }
    }
    return seen;
  }

  private void note(Component component, String text) {
    components.add(component);
    texts.add(component.getClass().getSimpleName() + " " + text);
  }

  private void cut(Component component, String text, String how, String tip) {
    if (!ToolTips.tells(tip, text) && !ToolTips.toldAround(component, text)) {
      report(component, text, how);
    }
  }

  private void report(Component component, String text, String how) {
    String line = text.strip().replace("\n", "\\n");
    cut.add(path(component) + " '" + line + "' " + how);
  }

  private static Rectangle inner(JComponent component) {
    return SwingUtilities.calculateInnerArea(component, new Rectangle());
  }

  /** The names around a component, from the outside. */
  private static String path(Component component) {
    String name = component.getName() == null ? "" : component.getName();
    String self = name.isEmpty() ? component.getClass().getSimpleName() : name;
    for (Component each = component.getParent(); each != null; each = each.getParent()) {
      if (each.getName() != null && !each.getName().startsWith("null.")) {
        return each.getName() + " / " + self;
      }
    }
    return self;
  }
}
