package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.Actions;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.text.Messages;
import org.pendant.project.program.check.NodeProblem;

/** Tree pane: the tree with what is around it: buttons, search, and what is not complete. */
@SuppressWarnings("serial") // never written to a stream
final class TreePane extends JPanel {
  /** Not one of this screen: the window's, but meant for the node. */
  private static final String RUN_FROM = "program.run-from";

  private final TreeList list;
  private final SearchBar search;
  private final IncompleteBar incomplete;
  private final JToggleButton follow = new JToggleButton(TreeTool.FOLLOW.icon());
  private final transient Actions actions;
  private final List<JButton> edits = new ArrayList<>();

  TreePane(
      TreeList list,
      SearchBar search,
      IncompleteBar incomplete,
      Actions actions,
      Runnable followToggled) {
    super(new BorderLayout());
    this.list = list;
    this.search = search;
    this.incomplete = incomplete;
    this.actions = actions;
    JPanel tools = new JPanel(new MigLayout("insets 2 4 2 4, gap 2, hidemode 3"));
    tools.setName("program-tools");
    Map<TreeTool, JButton> buttons = new EnumMap<>(TreeTool.class);
    for (TreeTool tool : TreeTool.values()) {
      if (tool != TreeTool.FOLLOW) {
        buttons.put(tool, tool(tool));
        tools.add(buttons.get(tool));
      }
    }
    follow.setName("program-follow");
    follow.setToolTipText(text("followKeepsTheNodeThatRuns"));
    follow.getAccessibleContext().setAccessibleName(text("followTheProgram"));
    follow.putClientProperty("JButton.buttonType", "toolBarButton");
    follow.setFocusable(false);
    follow.addActionListener(event -> followToggled.run());
    tools.add(follow);
    JButton more = more();
    tools.add(more);
    // one row always: what has no room is in the menu
    Squeeze squeeze =
        new Squeeze(
            tools,
            List.of(
                whole -> {
                  more.setVisible(!whole);
                  show(buttons, whole, TreeTool.CUT, TreeTool.COPY, TreeTool.PASTE);
                },
                whole -> show(buttons, whole, TreeTool.SUPPRESS, TreeTool.DELETE),
                whole -> show(buttons, whole, TreeTool.UP, TreeTool.DOWN)));
    squeeze.fitLater();
    JPanel head = new JPanel(new BorderLayout());
    head.add(tools, BorderLayout.NORTH);
    head.add(search, BorderLayout.SOUTH);
    JScrollPane scroll = new JScrollPane(list);
    scroll.setName("program-tree-scroll");
    scroll.setBorder(BorderFactory.createEmptyBorder());
    scroll.getVerticalScrollBar().setUnitIncrement(UIScale.scale(22));
    add(head, BorderLayout.NORTH);
    add(scroll);
    add(incomplete, BorderLayout.SOUTH);
    list.setComponentPopupMenu(menu());
    key("LEFT", () -> list.turn(false));
    key("RIGHT", () -> list.turn(true));
  }

  private static void show(Map<TreeTool, JButton> buttons, boolean visible, TreeTool... tools) {
    for (TreeTool each : tools) {
      buttons.get(each).setVisible(visible);
    }
  }

  private JButton more() {
    JButton more = new JButton("\u22ef");
    more.setName("program-more");
    more.putClientProperty("JButton.buttonType", "toolBarButton");
    more.setFocusable(false);
    more.setToolTipText(text("whatElseCanBeDoneWith"));
    more.getAccessibleContext().setAccessibleName(text("moreOfTheTree"));
    more.addActionListener(
        event -> {
          list.requestFocusInWindow();
          list.getComponentPopupMenu().show(more, 0, more.getHeight());
        });
    return more;
  }

  private void key(String keys, Runnable run) {
    list.registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(keys), JComponent.WHEN_FOCUSED);
  }

  private JButton tool(TreeTool tool) {
    JButton button =
        new JButton(tool.icon()) {
          @Override
          public String getToolTipText() {
            String keys = KeyText.shown(actions.keysOf(TreeActions.PREFIX + tool.action()));
            return keys.isEmpty() ? tool.title() : tool.title() + " (" + keys + ")";
          }
        };
    button.setName("program-" + tool.action());
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    // The tree keeps the keys.
    button.setFocusable(false);
    button.getAccessibleContext().setAccessibleName(tool.title());
    button.setToolTipText(tool.title());
    button.addActionListener(event -> run(tool.action()));
    if (tool != TreeTool.COPY) {
      edits.add(button);
    }
    return button;
  }

  private void run(String action) {
    list.requestFocusInWindow();
    // Whatever is enabled where keys go is so for the tree, which has them in a moment.
    actions.all().stream()
        .filter(each -> each.id().equals(TreeActions.PREFIX + action))
        .forEach(each -> each.run().run());
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("program-menu");
    menu.addPopupMenuListener(new Opening(() -> fill(menu)));
    return menu;
  }

  private void fill(JPopupMenu menu) {
    menu.removeAll();
    for (List<String> group :
        List.of(
            List.of("cut", "copy", "paste", "duplicate", "delete"),
            List.of("move-up", "move-down", "suppress", "rename"),
            List.of(RUN_FROM, "breakpoint", "script"),
            List.of("fold", "fold-all", "unfold-all", "as-text"))) {
      if (menu.getComponentCount() > 0) {
        menu.addSeparator();
      }
      for (String each : group) {
        actions.all().stream()
            .filter(
                action ->
                    action.id().equals(each.equals(RUN_FROM) ? each : TreeActions.PREFIX + each))
            .forEach(action -> menu.add(item(action)));
      }
    }
  }

  private JMenuItem item(Action action) {
    String keys = KeyText.shown(actions.keysOf(action.id()));
    JMenuItem item = new JMenuItem(action.title());
    item.setName("menu-" + action.id());
    item.setText(keys.isEmpty() ? action.title() : action.title() + "   " + keys);
    if (action.id().equals(RUN_FROM)) {
      item.setEnabled(action.enabled().getAsBoolean());
      String reason = actions instanceof ActionTable table ? table.reason(RUN_FROM) : "";
      if (!reason.isEmpty()) {
        item.setToolTipText(Messages.told(action.title(), reason));
      }
    }
    item.addActionListener(event -> action.run().run());
    return item;
  }

  /** Whether the tree can be changed. */
  void setEditable(boolean editable) {
    edits.forEach(each -> each.setEnabled(editable));
  }

  void showFollow(boolean on) {
    follow.setSelected(on);
  }

  SearchBar search() {
    return search;
  }

  void showProblems(List<NodeProblem> problems) {
    incomplete.show(problems);
  }

  IncompleteBar incomplete() {
    return incomplete;
  }

  @Override
  public Dimension getMinimumSize() {
    return new Dimension(UIScale.scale(150), UIScale.scale(120));
  }

  /**
   * Lets the user write another name over a node.
   *
   * @param done takes the name
   */
  void rename(long key, String now, Consumer<String> done) {
    list.reveal(key);
    list.textOf(key).ifPresent(place -> edit(place, now, done));
  }

  private void edit(Rectangle place, String now, Consumer<String> done) {
    JTextField field = new JTextField(now);
    field.setName("program-rename");
    field.getAccessibleContext().setAccessibleName(text("nameOfTheNode"));
    field.setBounds(place);
    boolean[] over = {false};
    Consumer<Boolean> end =
        accepted -> {
          if (!over[0]) {
            over[0] = true;
            String text = field.getText().strip();
            boolean focused = field.hasFocus();
            list.remove(field);
            list.repaint();
            if (focused) {
              list.requestFocusInWindow();
            }
            if (accepted) {
              done.accept(text);
            }
          }
        };
    field.registerKeyboardAction(
        event -> end.accept(true), KeyStroke.getKeyStroke("ENTER"), JComponent.WHEN_FOCUSED);
    field.registerKeyboardAction(
        event -> end.accept(false), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_FOCUSED);
    field.addFocusListener(
        new FocusAdapter() {
          @Override
          public void focusLost(FocusEvent event) {
            end.accept(!event.isTemporary());
          }
        });
    list.add(field);
    field.selectAll();
    field.requestFocusInWindow();
    list.repaint();
  }
}
