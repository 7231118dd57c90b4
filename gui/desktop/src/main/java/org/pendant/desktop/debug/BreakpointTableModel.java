package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.kit.table.RowsModel;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.BreakpointState;
import org.pendant.script.debug.HitRule;

/** Breakpoint table model: the breakpoints of the program in front as a table. */
@SuppressWarnings("serial") // never written to a stream
final class BreakpointTableModel extends RowsModel<Breakpoint> {
  static final int ENABLED = 0;
  static final int LINE = 1;
  static final int CONDITION = 2;
  static final int MESSAGE = 3;
  static final int FROM_HIT = 4;
  static final int HITS = 5;
  private static final List<String> TITLES =
      List.of(
          text("onColumn"),
          text("lineColumn"),
          text("condition"),
          text("logMessage"),
          text("fromHitColumn"),
          text("hitsColumn"));

  private final transient OpenBreakpoints openBreakpoints;

  BreakpointTableModel(OpenBreakpoints openBreakpoints) {
    super(TITLES);
    this.openBreakpoints = openBreakpoints;
  }

  /** Shows the open breakpoints, and what has become of them. */
  void show() {
    if (!show(openBreakpoints.all()) && getRowCount() > 0) {
      fireTableRowsUpdated(0, getRowCount() - 1);
    }
  }

  @Override
  public Class<?> getColumnClass(int column) {
    return column == ENABLED ? Boolean.class : String.class;
  }

  @Override
  protected Object cell(Breakpoint row, int column) {
    Optional<BreakpointState> state = openBreakpoints.state(row);
    return switch (column) {
      case ENABLED -> row.enabled();
      case LINE -> place(row, state);
      case CONDITION -> row.condition();
      case MESSAGE -> row.message();
      case FROM_HIT -> row.hits().text();
      default -> state.map(each -> Long.toString(each.hits())).orElse("");
    };
  }

  private static String place(Breakpoint row, Optional<BreakpointState> state) {
    OptionalInt stops = state.map(BreakpointState::statementLine).orElse(OptionalInt.empty());
    return stops.isPresent() && stops.getAsInt() != row.line()
        ? text("lineStopsOn", row.line(), stops.getAsInt())
        : Integer.toString(row.line());
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column != LINE && column != HITS;
  }

  /** Why {@code typed} does not say which hits count; empty if it does. */
  static String hitRefusal(String typed) {
    return HitRule.of(typed).isPresent()
        ? ""
        : text("fromHitIsMustBe", typed.strip(), HitRule.forms());
  }

  @Override
  public void setValueAt(Object typed, int index, int column) {
    if (index >= getRowCount()) {
      return;
    }
    Breakpoint row = row(index);
    switch (column) {
      case ENABLED -> openBreakpoints.change(row.enabled((Boolean) typed));
      case CONDITION -> openBreakpoints.change(row.when(typed.toString()));
      case MESSAGE -> openBreakpoints.change(row.logging(typed.toString()));
      case FROM_HIT -> {
        HitRule.of(typed.toString()).map(row::counting).ifPresent(openBreakpoints::change);
      }
      default -> throw new IllegalArgumentException("column is " + column + ", must be editable");
    }
  }
}
