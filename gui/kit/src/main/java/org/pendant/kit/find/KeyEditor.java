package org.pendant.kit.find;

import static org.pendant.kit.find.FindTexts.text;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
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
import javax.swing.table.TableCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.theme.Overlay;
import org.pendant.kit.theme.Palette;

/** Key editor: shows and changes the keys of the actions. */
public final class KeyEditor {
  private static final String WIDE_KEYS = "control alt shift F12";
  private static final int CELL_MARGINS = 16;

  private final ActionTable actions;
  private final Overlay overlay;
  private final JTextField filter = new JTextField();
  private final KeyTable model;
  private final JTable table;
  private final JTextField capture = new JTextField();
  private final JButton take = new JButton(text("takeItFromThere"));
  private final JLabel conflict = new JLabel(" ");

  /**
   * An editor that is closed.
   *
   * @param under what it may cover
   */
  public KeyEditor(ActionTable actions, JComponent under) {
    this.actions = actions;
    model = new KeyTable(actions);
    table =
        new JTable(model) {
          @Override
          public Component prepareRenderer(TableCellRenderer renderer, int row, int column) {
            return TableLook.tellingCut(
                super.prepareRenderer(renderer, row, column),
                getColumnModel().getColumn(column).getWidth());
          }
        };
    JPanel panel =
        new JPanel(
            new MigLayout(
                "insets 0, gap 8, wrap 1", "[grow, fill, 0:560:]", "[][][grow, 60::340][][]"));
    panel.setOpaque(false);
    JLabel heading = new JLabel(text("keys"));
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
    JPanel row =
        new JPanel(new MigLayout("insets 0, gap 8, hidemode 3, wrap 3", "[][180::][]push"));
    row.setOpaque(false);
    JLabel label = new JLabel(text("newKey"));
    label.setLabelFor(capture);
    conflict.setName("key-conflict");
    row.add(label);
    row.add(capture, "growx");
    row.add(button(take, "key-take", text("takesTheKeyAwayFromThe"), this::take));
    row.add(conflict, "span, growx, wmin 0");
    return row;
  }

  private JPanel buttons() {
    JPanel row = new JPanel(new WrappingRow(4));
    row.setOpaque(false);
    row.add(
        button(new JButton(text("noKey")), "key-none", text("takesTheKeyAway"), () -> bind("")));
    row.add(button(new JButton(text("reset")), "key-reset", text("theKeyItCameWith"), this::reset));
    row.add(
        button(
            new JButton(text("resetAll")),
            "key-reset-all",
            text("allKeysAsTheyCame"),
            this::resetAll));
    row.add(
        button(new JButton(text("close")), "key-close", text("closesThisPanelEsc"), this::close));
    return row;
  }

  private void close() {
    overlay.close();
  }

  private static JButton button(JButton button, String name, String tip, Runnable run) {
    button.setName(name);
    button.setToolTipText(tip);
    button.getAccessibleContext().setAccessibleName(button.getText());
    button.addActionListener(event -> run.run());
    return button;
  }

  private void setUpFilter() {
    filter.setName("key-filter");
    filter.putClientProperty("JTextField.placeholderText", text("filterByTitleOrKey"));
    filter.setToolTipText(text("lettersOfATitleOrA"));
    filter.getAccessibleContext().setAccessibleName(text("filterActions"));
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
    table.setToolTipText(text("chooseAnActionThenPressIts"));
    table.getAccessibleContext().setAccessibleName(text("actionsAndTheirKeys"));
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setFillsViewportHeight(true);
    // Tab leaves a table that cannot be edited.
    table.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    table.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    table.getColumnModel().getColumn(0).setPreferredWidth(320);
    int keys = table.getFontMetrics(table.getFont()).stringWidth(KeyText.shown(WIDE_KEYS));
    table.getColumnModel().getColumn(1).setPreferredWidth(keys + CELL_MARGINS);
    table.getColumnModel().getColumn(1).setMinWidth(keys + CELL_MARGINS);
    table.getSelectionModel().addListSelectionListener(event -> selected());
  }

  private void setUpCapture() {
    capture.setName("key-capture");
    capture.setEditable(false);
    capture.putClientProperty("JTextField.placeholderText", text("clickHereAndPressAKey"));
    capture.setToolTipText(text("theKeyThatYouPressHere"));
    capture.getAccessibleContext().setAccessibleName(text("pressTheNewKey"));
    capture.addKeyListener(
        new KeyAdapter() {
          @Override
          public void keyPressed(KeyEvent event) {
            pressed(event);
          }
        });
  }

  private void pressed(KeyEvent event) {
    KeyStroke stroke = KeyStroke.getKeyStrokeForEvent(event);
    if (KeyText.modifier(event.getKeyCode())) {
      return;
    }
    if (KeyText.bindable(stroke)) {
      event.consume();
      bind(KeyText.keys(stroke));
    } else if (event.getKeyCode() != KeyEvent.VK_ESCAPE) {
      say(text("isNeededForWritingAndMoving", KeyText.shown(stroke)), true);
    }
  }

  private void say(String text, boolean wrong) {
    conflict.setForeground(wrong ? Palette.error() : Palette.quiet());
    conflict.setText(text.isEmpty() ? " " : text);
    conflict.setToolTipText(text.isEmpty() ? null : text);
  }

  /** The actions and their keys. */
  JTable table() {
    return table;
  }

  /** Opens it. */
  public void open() {
    filter.setText("");
    model.filter("");
    overlay.open();
    overlay.bringToFront();
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
    return row < 0 ? Optional.empty() : Optional.of(model.row(row));
  }

  private void selected() {
    capture.setText(chosen().map(each -> KeyText.shown(actions.keysOf(each.id()))).orElse(""));
    List<Action> others =
        chosen()
            .map(each -> actions.conflicts(each.id(), actions.keysOf(each.id())))
            .orElse(List.of());
    take.setVisible(!others.isEmpty());
    String titles = String.join(", ", others.stream().map(Action::title).toList());
    say(others.isEmpty() ? "" : text("alsoTheKeyOf", titles), true);
  }

  /** Leaves the key to the chosen action alone. */
  private void take() {
    chosen()
        .ifPresent(
            each ->
                actions
                    .conflicts(each.id(), actions.keysOf(each.id()))
                    .forEach(other -> actions.rebind(other.id(), "")));
    changed();
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
