package org.pendant.gui.shell.find;

import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.pendant.gui.shell.look.Overlay;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.ActionTable;
import org.pendant.gui.workbench.KeyText;
import org.pendant.gui.workbench.Palette;

/** Shows and changes the keys of the actions. */
public final class KeyEditor {
  private final ActionTable actions;
  private final Overlay overlay;
  private final JTextField filter = new JTextField();
  private final KeyTable model;
  private final JTable table;
  private final JTextField capture = new JTextField();
  private final JLabel conflict = new JLabel(" ");

  /**
   * An editor that is closed.
   *
   * @param under what it may cover
   */
  public KeyEditor(ActionTable actions, JComponent under) {
    this.actions = actions;
    model = new KeyTable(actions);
    table = new JTable(model);
    JPanel panel =
        new JPanel(
            new MigLayout(
                "insets 0, gap 8, wrap 1", "[grow, fill, 560::]", "[][][grow, 160::340][][]"));
    panel.setOpaque(false);
    JLabel heading = new JLabel("Keys");
    heading.putClientProperty("FlatLaf.styleClass", "h3");
    panel.add(heading);
    panel.add(filter);
    panel.add(new JScrollPane(table), "grow");
    panel.add(captureRow());
    panel.add(buttons());
    overlay = new Overlay("key-editor", under, panel);
    setUpFilter();
    setUpTable();
    setUpCapture();
    selected();
  }

  private JPanel captureRow() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][180::][grow, 0::]"));
    row.setOpaque(false);
    JLabel label = new JLabel("New key");
    label.setLabelFor(capture);
    conflict.setName("key-conflict");
    row.add(label);
    row.add(capture, "growx");
    row.add(conflict, "growx");
    return row;
  }

  private JPanel buttons() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8", "[][][]push[]"));
    row.setOpaque(false);
    row.add(button("key-none", "No key", "Takes the key away", () -> bind("")));
    row.add(button("key-reset", "Reset", "The key it came with", this::reset));
    row.add(button("key-reset-all", "Reset all", "All keys as they came", this::resetAll));
    row.add(button("key-close", "Close", "Closes this panel (Esc)", () -> close()));
    return row;
  }

  private void close() {
    overlay.close();
  }

  private static JButton button(String name, String text, String tip, Runnable run) {
    JButton button = new JButton(text);
    button.setName(name);
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(text);
    button.addActionListener(event -> run.run());
    return button;
  }

  private void setUpFilter() {
    filter.setName("key-filter");
    filter.putClientProperty("JTextField.placeholderText", "Filter by title or key");
    filter.setToolTipText("Letters of a title, or a key such as F5");
    filter.getAccessibleContext().setAccessibleName("Filter actions");
    filter
        .getDocument()
        .addDocumentListener(
            new Typed(
                () -> {
                  model.filter(filter.getText());
                  selectFirst();
                }));
  }

  private void setUpTable() {
    table.setName("key-table");
    table.setToolTipText("Choose an action, then press its new key in the field below");
    table.getAccessibleContext().setAccessibleName("Actions and their keys");
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setFillsViewportHeight(true);
    table.getColumnModel().getColumn(0).setPreferredWidth(340);
    table.getSelectionModel().addListSelectionListener(event -> selected());
  }

  private void setUpCapture() {
    capture.setName("key-capture");
    capture.setEditable(false);
    capture.setFocusTraversalKeysEnabled(false);
    capture.putClientProperty("JTextField.placeholderText", "Click here and press a key");
    capture.setToolTipText("The key that you press here does the chosen action from now on");
    capture.getAccessibleContext().setAccessibleName("Press the new key");
    capture.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            if (event.getKeyCode() == KeyEvent.VK_ESCAPE || KeyText.modifier(event.getKeyCode())) {
              return;
            }
            event.consume();
            bind(KeyText.keys(KeyStroke.getKeyStrokeForEvent(event)));
          }
        });
  }

  /** Opens it. */
  public void open() {
    filter.setText("");
    model.filter("");
    overlay.open();
    selectFirst();
    filter.requestFocusInWindow();
  }

  private void selectFirst() {
    if (table.getRowCount() > 0) {
      table.setRowSelectionInterval(0, 0);
    }
  }

  private Optional<Action> chosen() {
    int row = table.getSelectedRow();
    return row < 0 ? Optional.empty() : Optional.of(model.action(row));
  }

  private void selected() {
    capture.setText(chosen().map(each -> KeyText.shown(actions.keysOf(each.id()))).orElse(""));
    List<Action> others =
        chosen()
            .map(each -> actions.conflicts(each.id(), actions.keysOf(each.id())))
            .orElse(List.of());
    conflict.setForeground(Palette.error());
    conflict.setText(
        others.isEmpty()
            ? " "
            : "Also the key of: " + String.join(", ", others.stream().map(Action::title).toList()));
    conflict.setToolTipText(conflict.getText());
  }

  private void bind(String keys) {
    chosen().ifPresent(each -> actions.rebind(each.id(), keys));
    changed();
  }

  private void reset() {
    chosen().ifPresent(each -> actions.reset(each.id()));
    changed();
  }

  private void resetAll() {
    actions.all().forEach(each -> actions.reset(each.id()));
    changed();
  }

  private void changed() {
    model.fireTableRowsUpdated(0, Math.max(0, model.getRowCount() - 1));
    selected();
  }
}
