package org.pendant.desktop.installation;

import static org.pendant.desktop.installation.InstallationTexts.text;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.util.Locale;
import javax.swing.AbstractAction;
import javax.swing.DefaultCellEditor;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.TableCellEditor;
import javax.swing.table.TableCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.table.EditableTable;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.theme.Palette;

/** Signals page: names, uses and levels of all signals. */
final class SignalsPage implements Page {
  private static final int MIN_ROWS = 10;
  private static final int LIVE_MS = 100;

  private final TitledCard card = new TitledCard("io", text("io"), "[grow, fill]");
  private final SignalTable model;
  private final SignalsTable table;
  private final Remark problem = new Remark("signals-problem", Palette::error);
  private final JTextField filter = new JTextField(12);
  private final JComboBox<SignalTable.Group> group = new JComboBox<>(SignalTable.Group.values());
  private long shownNs;

  SignalsPage(Editing editing) {
    model = new SignalTable(editing, problem::say);
    table = new SignalsTable(model);
    TitledCard.named(table, "signals-table", text("signalsF2ChangesTheChosenCell"));
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setCellSelectionEnabled(true);
    table.putClientProperty("terminateEditOnFocusLost", true);
    table.getTableHeader().setReorderingAllowed(false);
    int[] widths = {140, 150, 190, 90, 80};
    table.getColumnModel().getColumn(0).setMinWidth(widths[0]);
    for (int i = 0; i < widths.length; i++) {
      table.getColumnModel().getColumn(i).setPreferredWidth(widths[i]);
    }
    TableLook.fitTitles(table);
    TitledCard.named(group, "signals-group", text("whichSignalsAreListed"));
    group.addActionListener(
        event -> {
          stop();
          model.show(group.getItemAt(Math.max(0, group.getSelectedIndex())), filter.getText());
        });
    TitledCard.named(filter, "signals-filter", text("partOfASignalOrName"));
    filter.putClientProperty("JTextField.placeholderText", text("filter"));
    filter
        .getDocument()
        .addDocumentListener(
            new Typed(
                () -> {
                  stop();
                  model.show(
                      group.getItemAt(Math.max(0, group.getSelectedIndex())), filter.getText());
                }));
    JPanel head = new JPanel(new MigLayout("insets 0, gap 8", "[][][grow, fill]"));
    head.setOpaque(false);
    JLabel label = new JLabel(text("show"));
    label.setLabelFor(group);
    head.add(label);
    head.add(group);
    head.add(filter, "wmin 60");
    card.add(head, "wmin 0");
    JScrollPane scroll = new JScrollPane(table);
    scroll.setName("signals-scroll");
    card.add(scroll, "wmin 0, growy, pushy, h " + MIN_ROWS * 24 + ":" + MIN_ROWS * 24 + ":");
    card.add(problem, Remark.LAYOUT);
    Remark note = new Remark("signals-note", Palette::quiet);
    note.say(text("useWhatAHighInputDoes"));
    card.add(note, Remark.LAYOUT);
    table
        .getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke("ENTER"), "edit-cell");
    table
        .getActionMap()
        .put(
            "edit-cell",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                if (table.isEditing()) {
                  stop();
                } else if (table.getSelectedRow() >= 0
                    && table.editCellAt(table.getSelectedRow(), table.getSelectedColumn())) {
                  table.getEditorComponent().requestFocusInWindow();
                }
              }
            });
  }

  private void stop() {
    if (table.isEditing()) {
      table.getCellEditor().stopCellEditing();
    }
  }

  /** A table whose rows offer what their signals can do. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class SignalsTable extends EditableTable {
    private final transient SignalTable signals;

    SignalsTable(SignalTable signals) {
      super(signals);
      this.signals = signals;
    }

    @Override
    public TableCellEditor getCellEditor(int row, int column) {
      if (column == SignalTable.NAME) {
        return super.getCellEditor(row, column);
      }
      JComboBox<String> box =
          TitledCard.named(
              new JComboBox<>(signals.choices(row, column).toArray(new String[0])),
              "signals-editor",
              signals.getColumnName(column).toLowerCase(Locale.ROOT));
      return new DefaultCellEditor(box);
    }

    @Override
    public Component prepareRenderer(TableCellRenderer renderer, int row, int column) {
      return TableLook.tellingCut(
          super.prepareRenderer(renderer, row, column),
          getColumnModel().getColumn(column).getWidth());
    }

    @Override
    public void updateUI() {
      super.updateUI();
      setRowHeight(Math.max(getRowHeight(), getFontMetrics(getFont()).getHeight() * 3 / 2));
    }
  }

  @Override
  public JComponent component() {
    return card;
  }

  @Override
  public boolean fillsHeight() {
    return true;
  }

  @Override
  public void show() {
    if (!table.isEditing()) {
      model.follow();
    }
  }

  @Override
  public void refresh(ControllerState state) {
    if (System.nanoTime() - shownNs > LIVE_MS * 1_000_000L) {
      shownNs = System.nanoTime();
      model.take(state);
    }
  }
}
