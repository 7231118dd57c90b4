package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.table.AbstractTableModel;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.SentenceUnits;
import org.pendant.desktop.whatif.ResultWords.Figure;
import org.pendant.recording.whatif.VariantOutcome;

/** Variant table model: the variants, and what came of them beside each. */
@SuppressWarnings("serial") // never written to a stream
final class VariantTableModel extends AbstractTableModel {
  static final int NAME = 0;
  static final int SPEED = 1;
  static final int LOAD = 2;
  static final int PROGRAM = 3;
  static final int RESULT = 4;
  static final String AS_IT_RAN = text("asItRan");
  static final String AS_EDITED = text("asEditedNow");
  private static final String AS_IT_WAS = text("asItWas");
  private static final List<String> TITLES =
      List.of(text("variant"), text("speed"), text("load"), text("program"), text("result"));
  private static final List<Figure> FIGURES = List.of(Figure.values());

  private final transient WhatIfPresenter presenter;
  private final transient Supplier<PoseForm> form;
  private final transient Places places;
  private int shown;

  /** What lines of the program are called. */
  @FunctionalInterface
  interface Places {
    /**
     * Within a sentence.
     *
     * @param edited whether the program ran as it is edited now
     */
    String of(int line, boolean edited);
  }

  /**
   * The variants of a presenter.
   *
   * @param form in which people read numbers now
   */
  VariantTableModel(WhatIfPresenter presenter, Supplier<PoseForm> form, Places places) {
    this.places = places;
    this.presenter = presenter;
    this.form = form;
    shown = presenter.rows().size();
  }

  /** Shows the variants as they are now. */
  void show() {
    int count = getRowCount();
    if (count == shown) {
      fireTableRowsUpdated(0, count - 1);
    } else {
      shown = count;
      fireTableDataChanged();
    }
  }

  /** The number that a column compares. */
  static Optional<Figure> figure(int column) {
    return column > RESULT ? Optional.of(FIGURES.get(column - RESULT - 1)) : Optional.empty();
  }

  @Override
  public int getRowCount() {
    return presenter.rows().size();
  }

  @Override
  public int getColumnCount() {
    return TITLES.size() + FIGURES.size();
  }

  @Override
  public String getColumnName(int column) {
    return figure(column).map(Figure::title).orElseGet(() -> TITLES.get(column));
  }

  @Override
  public boolean isCellEditable(int row, int column) {
    return column < RESULT && !presenter.running();
  }

  /** Whether a cell says that something is as it was, and not what somebody has typed. */
  boolean untouched(int row, int column) {
    VariantRow at = presenter.rows().get(row);
    return switch (column) {
      case SPEED -> at.speed().isEmpty();
      case LOAD -> at.load().isEmpty();
      case PROGRAM -> !at.edited();
      default -> false;
    };
  }

  @Override
  public Object getValueAt(int row, int column) {
    VariantRow at = presenter.rows().get(row);
    return switch (column) {
      case NAME -> at.name();
      case SPEED -> at.speed().isEmpty() ? AS_IT_WAS : at.speed() + " %";
      case LOAD -> at.load().isEmpty() ? AS_IT_WAS : at.load() + " kg";
      case PROGRAM -> at.edited() ? AS_EDITED : AS_IT_RAN;
      case RESULT -> SentenceUnits.in(ResultWords.state(presenter.results().get(row)), form.get());
      default -> figure(column).map(each -> figure(each, row)).orElse("");
    };
  }

  private boolean edited(int row) {
    return presenter.rows().get(row).edited();
  }

  /** What is edited: nothing where a cell says that something is as it was. */
  String typed(int row, int column) {
    return untouched(row, column) && column != PROGRAM ? "" : getValueAt(row, column).toString();
  }

  private String figure(Figure figure, int row) {
    List<VariantResult> results = presenter.results();
    Optional<VariantOutcome> first = row == 0 ? Optional.empty() : results.getFirst().finished();
    return results
        .get(row)
        .finished()
        .map(each -> ResultWords.figure(figure, each, first))
        .orElse("");
  }

  /** More about a cell than fits into it; empty for nothing. */
  String about(int row, int column) {
    return figure(column)
        .flatMap(
            each ->
                presenter
                    .results()
                    .get(row)
                    .finished()
                    .map(
                        outcome ->
                            getValueAt(row, column)
                                + ": "
                                + ResultWords.about(
                                    each, outcome, line -> places.of(line, edited(row)))))
        .orElseGet(
            () ->
                switch (column) {
                  case SPEED -> text("theSpeedSliderFromTheMoment");
                  case LOAD -> text("whatTrulyHangsOnTheFlange");
                  case PROGRAM -> text("aProgramAsItIsEdited");
                  default -> getValueAt(row, column).toString();
                });
  }

  @Override
  public void setValueAt(Object typed, int row, int column) {
    if (row >= getRowCount()) {
      return;
    }
    VariantRow at = presenter.rows().get(row);
    String text = typed.toString();
    VariantRow wanted =
        switch (column) {
          case NAME -> VariantRow.nameRefusal(text).isEmpty() ? at.named(text) : at;
          case SPEED -> VariantRow.speedRefusal(text).isEmpty() ? at.withSpeed(text) : at;
          case LOAD -> VariantRow.loadRefusal(text).isEmpty() ? at.withLoad(text) : at;
          case PROGRAM -> at.withEdited(text.equals(AS_EDITED));
          default ->
              throw new IllegalArgumentException("column is " + column + ", must be editable");
        };
    presenter.change(row, wanted);
  }
}
