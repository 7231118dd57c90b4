package org.pendant.gui.debug;

import java.awt.EventQueue;
import javax.swing.JComponent;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JScrollPane;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.workbench.View;
import org.pendant.gui.workbench.Workbench;

/** The variables of a program that is held. */
public final class VariablesView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "variables";

  private static final String NOTE =
      "The program is not stopped. Set a breakpoint with F9 and run the program, or hold it while"
          + " it runs: its variables appear here.";

  private final Workbench workbench;
  private final DebugPresenter debug;
  private final ValueTable table;
  private final DebugPanel panel;

  /** Without values yet. */
  public VariablesView(Workbench workbench, DebugPresenter debug) {
    assert EventQueue.isDispatchThread();
    this.workbench = workbench;
    this.debug = debug;
    table = new ValueTable("variables-table", debug.variables(), false, (row, text) -> {});
    table.getAccessibleContext().setAccessibleName("Variables: name, value and kind");
    table.setComponentPopupMenu(menu());
    panel = new DebugPanel("variables", new JScrollPane(table));
    debug.addListener(this::show);
    show();
  }

  private JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.add(item("Change value", "F2, or a double click", table::editValue));
    menu.add(item("Copy value", "Puts the value on the clipboard", table::copyValue));
    menu.add(item("Copy expression", "What yields the value", table::copyExpression));
    menu.addSeparator();
    menu.add(item("Add to watches", "Shows it at every stop", this::watch));
    return menu;
  }

  static JMenuItem item(String title, String tip, Runnable run) {
    JMenuItem item = new JMenuItem(title);
    item.setToolTipText(tip);
    item.addActionListener(event -> run.run());
    return item;
  }

  private void watch() {
    table
        .selectedValue()
        .ifPresent(
            value -> {
              debug.addWatch(ValueTable.expression(value));
              workbench.show(WatchesView.ID);
            });
  }

  private void show() {
    if (debug.showsValues()) {
      panel.showContent(debug.stopText());
    } else {
      panel.showNote(NOTE);
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return "Variables";
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void refresh(ControllerState state) {
    debug.refresh(state);
  }
}
