package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Insets;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.DefaultCellEditor;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import javax.swing.table.AbstractTableModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;
import org.pendant.desktop.sweep.DraftParameter.Part;
import org.pendant.kit.table.EditableTable;
import org.pendant.kit.table.MiddleElision;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.theme.Palette;
import org.pendant.sweep.plan.SamplingMethod;
import org.pendant.sweep.plan.TargetText;

/** Parameter table: all that a sweep could vary, a row each, edited in place. */
@SuppressWarnings("serial") // never written to a stream
final class ParameterTable extends EditableTable {
  private static final int CHOSEN = 0;
  private static final int WHAT = 1;
  private static final int NOW = 2;
  private static final int VALUES = 6;
  private static final int NAME = 7;
  private static final List<String> TITLES =
      List.of(
          "",
          text("parameterColumn"),
          text("nowColumn"),
          text("fromColumn"),
          text("toColumn"),
          text("stepsColumn"),
          text("valuesColumn"),
          text("nameColumn"));
  private static final List<Integer> WIDTHS = List.of(28, 200, 78, 64, 64, 50, 84, 84);
  private static final int MIN_WIDTH = 44;
  private static final int MIN_NAME = 90;
  private static final int MAX_WIDTH = 140;
  private static final int CELL_SPACE = 8;
  private static final int TITLE_SPACE = 14;
  private static final int ROW_SPACE = 8;

  private final transient SweepPresenter presenter;
  private final Model model;

  ParameterTable(SweepPresenter presenter) {
    this(presenter, new Model(presenter));
  }

  private ParameterTable(SweepPresenter presenter, Model model) {
    super(model);
    this.presenter = presenter;
    this.model = model;
    TableLook.apply(this, "sweep-parameters", text("parametersThatTheSweepCanVary"));
    TableLook.editInPlace(this);
    JTextField field = new JTextField();
    field.setName("sweep-cell");
    for (int i = 0; i < WIDTHS.size(); i++) {
      getColumnModel().getColumn(i).setPreferredWidth(WIDTHS.get(i));
      getColumnModel()
          .getColumn(i)
          .setMinWidth(i == CHOSEN ? WIDTHS.get(i) : i == WHAT ? MIN_NAME : MIN_WIDTH);
      if (i > CHOSEN) {
        getColumnModel().getColumn(i).setCellRenderer(new Cell());
        getColumnModel().getColumn(i).setCellEditor(new DefaultCellEditor(field));
      }
    }
    getColumnModel().getColumn(CHOSEN).setMaxWidth(WIDTHS.get(CHOSEN));
    JCheckBox box = new JCheckBox();
    box.setHorizontalAlignment(SwingConstants.CENTER);
    getColumnModel().getColumn(CHOSEN).setCellEditor(new DefaultCellEditor(box));
    registerKeyboardAction(
        event -> turn(), KeyStroke.getKeyStroke("SPACE"), JComponent.WHEN_FOCUSED);
  }

  private void turn() {
    int row = getSelectedRow();
    if (row >= 0) {
      model.setValueAt(!(Boolean) model.getValueAt(row, CHOSEN), row, CHOSEN);
    }
  }

  /** Shows those with a word in them, or those that are chosen alone. */
  void filter(String word, boolean chosenOnly) {
    if (isEditing()) {
      getCellEditor().stopCellEditing();
    }
    model.word = word.strip().toLowerCase(Locale.ROOT);
    model.chosenOnly = chosenOnly;
    model.show();
  }

  /** Shows the draft as it is now. */
  void showDraft() {
    int selected = getSelectedRow();
    if (model.show()) {
      if (isEditing()) {
        getCellEditor().cancelCellEditing();
      }
      fitColumns();
    }
    if (selected >= 0 && selected < model.getRowCount() && getSelectedRow() < 0) {
      setRowSelectionInterval(selected, selected);
    }
  }

  /** Columns of numbers and of names in results are as wide as what is in them, filtered or not. */
  private void fitColumns() {
    FontMetrics metrics = getFontMetrics(getFont());
    for (int column = NOW; column < getColumnCount(); column++) {
      int widest = metrics.stringWidth(getColumnName(column)) + UIScale.scale(TITLE_SPACE);
      for (DraftParameter each : column == VALUES ? List.<DraftParameter>of() : model.all()) {
        String text = String.valueOf(Model.value(each, column));
        widest = Math.max(widest, metrics.stringWidth(text) + UIScale.scale(CELL_SPACE));
      }
      int wanted = Math.min(widest, UIScale.scale(MAX_WIDTH));
      getColumnModel().getColumn(column).setPreferredWidth(wanted);
    }
  }

  /** What is left is for what varies: where that is little, tips have the whole of it. */
  @Override
  public void doLayout() {
    if (getTableHeader().getResizingColumn() == null) {
      TableColumn what = getColumnModel().getColumn(WHAT);
      int others =
          Collections.list(getColumnModel().getColumns()).stream()
              .filter(each -> !each.equals(what))
              .mapToInt(TableColumn::getPreferredWidth)
              .sum();
      what.setPreferredWidth(Math.max(what.getMinWidth(), getWidth() - others));
    }
    super.doLayout();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    TableLook.fitRows(this, ROW_SPACE);
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    if (row < 0 || column < 0) {
      return text("spaceTicksAParameterF2Or");
    }
    DraftParameter at = model.at(row);
    return model
        .error(row, column)
        .orElseGet(
            () ->
                column == WHAT
                    ? text("inPlans", at.group(), at.title(), TargetText.of(at.target()))
                    : column == VALUES && at.values().isBlank()
                        ? text("aListInPlaceOfFrom")
                        : String.valueOf(model.getValueAt(row, column)));
  }

  /** The rows. */
  private static final class Model extends AbstractTableModel {
    private final transient SweepPresenter presenter;
    private transient List<Integer> places = List.of();
    private String word = "";
    private boolean chosenOnly;

    Model(SweepPresenter presenter) {
      this.presenter = presenter;
    }

    private List<DraftParameter> all() {
      return presenter.draft().map(PlanDraft::parameters).orElse(List.of());
    }

    /** Whether rows have come or gone. */
    boolean show() {
      List<Integer> next = new ArrayList<>();
      List<DraftParameter> all = all();
      for (int i = 0; i < all.size(); i++) {
        DraftParameter each = all.get(i);
        String text =
            (each.group() + " " + each.title() + " " + TargetText.of(each.target()))
                .toLowerCase(Locale.ROOT);
        if (text.contains(word) && (each.chosen() || !chosenOnly)) {
          next.add(i);
        }
      }
      boolean others = !next.equals(places);
      places = next;
      if (others) {
        fireTableDataChanged();
      } else if (!places.isEmpty()) {
        fireTableRowsUpdated(0, places.size() - 1);
      }
      return others;
    }

    DraftParameter at(int row) {
      return all().get(places.get(row));
    }

    Optional<String> error(int row, int column) {
      return part(column)
          .flatMap(
              part ->
                  Optional.ofNullable(
                      presenter.check().errors().get(DraftCheck.field(at(row).target(), part))));
    }

    private static Optional<Part> part(int column) {
      return switch (column) {
        case 3 -> Optional.of(Part.FROM);
        case 4 -> Optional.of(Part.TO);
        case 5 -> Optional.of(Part.STEPS);
        case VALUES -> Optional.of(Part.VALUES);
        case NAME -> Optional.of(Part.NAME);
        default -> Optional.empty();
      };
    }

    @Override
    public int getRowCount() {
      return places.size();
    }

    @Override
    public int getColumnCount() {
      return TITLES.size();
    }

    @Override
    public String getColumnName(int column) {
      return TITLES.get(column);
    }

    @Override
    public Class<?> getColumnClass(int column) {
      return column == CHOSEN ? Boolean.class : String.class;
    }

    @Override
    public boolean isCellEditable(int row, int column) {
      return !presenter.runs() && (column == CHOSEN || part(column).isPresent());
    }

    @Override
    public Object getValueAt(int row, int column) {
      return value(at(row), column);
    }

    static Object value(DraftParameter at, int column) {
      return switch (column) {
        case CHOSEN -> at.chosen();
        case WHAT -> at.title();
        case NOW ->
            at.unit().isEmpty() || at.now().isEmpty() ? at.now() : at.now() + " " + at.unit();
        default -> at.text(part(column).orElseThrow());
      };
    }

    @Override
    public void setValueAt(Object value, int row, int column) {
      if (presenter.runs() || row >= places.size()) {
        return;
      }
      DraftParameter before = at(row);
      int place = places.get(row);
      DraftParameter after =
          column == CHOSEN
              ? before.withChosen((Boolean) value)
              : before.with(part(column).orElseThrow(), value.toString());
      boolean typed = column == CHOSEN || !value.equals(getValueAt(row, column));
      if (typed) {
        presenter.change(draft -> draft.withParameter(place, after));
      }
    }
  }

  /** A cell; red where something is wrong, quiet where it does not count. */
  private final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      DraftParameter at = model.at(row);
      boolean wrong = model.error(row, column).isPresent();
      if (wrong) {
        setBorder(BorderFactory.createLineBorder(Palette.error()));
        setText(getText().isBlank() ? "?" : getText());
      }
      if (column == WHAT || column == NAME) {
        Insets insets = getInsets();
        int width = table.getColumnModel().getColumn(column).getWidth();
        setText(
            MiddleElision.fit(
                getText(), getFontMetrics(getFont()), width - insets.left - insets.right));
      }
      if (!selected) {
        setForeground(
            wrong ? Palette.error() : counts(at, column) ? table.getForeground() : Palette.quiet());
      }
      return this;
    }

    private boolean counts(DraftParameter at, int column) {
      boolean listed = !at.values().isBlank();
      SamplingMethod method =
          presenter.draft().map(each -> each.sampling().method()).orElse(SamplingMethod.GRID);
      return switch (column) {
        case WHAT -> true;
        case 3, 4 -> at.chosen() && !listed;
        case 5 -> at.chosen() && !listed && !method.counted();
        default -> at.chosen();
      };
    }
  }
}
