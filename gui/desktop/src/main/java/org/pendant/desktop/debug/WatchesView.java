package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;

/** Watches view: expressions that are computed at every stop. */
public final class WatchesView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "watches";

  /** What people read on its tab. */
  public static final String TITLE = text("watches");

  private static final String NOTE = text("noWatchesYetTypeAnExpression");

  private final DebugPresenter debug;
  private final ValueTable table;
  private final LiveTree live;
  private final JTextField field = new JTextField();
  private final DebugPanel middle;
  private final JPanel panel = new JPanel(new BorderLayout());
  private final Workbench workbench;
  private Supplier<Optional<ControllerState>> past = Optional::empty;
  private boolean wasPast;

  /** With the expressions that were watched last. */
  public WatchesView(Workbench workbench, DebugPresenter debug) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.debug = debug;
    table =
        new ValueTable(
            "watches-table",
            debug.watchTree(),
            true,
            (row, text) -> debug.changeWatch(ValueTable.expression(row), text),
            Optional.empty());
    table.getAccessibleContext().setAccessibleName(text("watchesExpressionValueAndKind"));
    table.setComponentPopupMenu(menu());
    table.registerKeyboardAction(
        event -> remove(), KeyStroke.getKeyStroke("DELETE"), JComponent.WHEN_FOCUSED);
    live =
        new LiveTree(
            debug.watchTree(),
            () -> System.nanoTime() / 1_000_000,
            (samples, running, unfolded) -> Watches.live(debug.watches(), samples, unfolded));
    middle = new DebugPanel("watches-content", new JScrollPane(table));
    panel.setName("watches");
    panel.add(middle);
    panel.add(adding(), BorderLayout.SOUTH);
    ExpressionTransfer drop = new ExpressionTransfer(Optional.of(this::add));
    panel.setTransferHandler(drop);
    table.setTransferHandler(drop);
    debug.addListener(this::show);
    debug.watchTree().addListener(this::show);
    show();
  }

  /** Has {@code listener} hear each expression that is selected. */
  public void whenSelected(Consumer<String> listener) {
    table.whenSelected(listener);
  }

  /** Has the values of a moment of the past shown, while there is one. */
  public void setPast(Supplier<Optional<ControllerState>> moment) {
    past = moment;
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.add(
        VariablesView.item(
            text("changeExpression"),
            text("anotherOneInItsPlace"),
            () -> table.edit(ValueTableModel.NAME)));
    menu.add(VariablesView.item(text("changeValue"), text("f2OrADoubleClick"), table::editValue));
    menu.add(VariablesView.item(text("copyValue"), text("putsItOnTheClipboard"), table::copyValue));
    menu.add(VariablesView.changeBefore(workbench));
    menu.addSeparator();
    menu.add(VariablesView.item(text("remove"), text("deleteKey"), this::remove));
    return menu;
  }

  private JPanel adding() {
    field.setName("watch-field");
    field.putClientProperty("JTextField.placeholderText", text("expressionToWatch"));
    field.setToolTipText(text("anExpressionThatIsComputedAt"));
    field.getAccessibleContext().setAccessibleName(text("expressionToWatch"));
    field.putClientProperty("FlatLaf.styleClass", "monospaced");
    field.addActionListener(event -> addTyped());
    JButton add = new JButton(text("add"));
    add.setName("watch-add");
    add.setToolTipText(text("addsTheExpressionToTheWatches"));
    add.getAccessibleContext().setAccessibleName(text("addWatch"));
    add.addActionListener(event -> addTyped());
    JPanel row = new JPanel(new MigLayout("insets 8, fillx", "[grow]8[]"));
    row.add(field, "growx, wmin 0");
    row.add(add);
    return row;
  }

  private void addTyped() {
    add(field.getText());
    field.setText("");
  }

  private void add(String expression) {
    debug.addWatch(expression);
    show();
  }

  private void remove() {
    table
        .selectedValue()
        .filter(value -> value.level() == 0)
        .ifPresent(value -> debug.changeWatch(ValueTable.expression(value), ""));
    show();
  }

  private void show() {
    if (debug.watches().isEmpty()) {
      middle.showNote(NOTE);
    } else {
      middle.showContent("");
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return TITLE;
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void refresh(ControllerState state) {
    Optional<ControllerState> then = past.get();
    if (then.isPresent()) {
      live.refresh(then.get(), false);
    } else {
      debug.refresh(state);
      if (wasPast) {
        // What a debugger found at a stop was replaced by the past.
        debug.selected().ifPresent(scope -> debug.select(scope.thread(), scope.depth()));
      }
      live.refresh(state, debug.showsValues());
    }
    wasPast = then.isPresent();
  }
}
