package org.pendant.desktop.lines;

import static org.pendant.desktop.lines.LineTexts.text;

import java.awt.BorderLayout;
import java.awt.KeyboardFocusManager;
import java.util.List;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.table.RowsModel;
import org.pendant.recording.explain.MotionExplanation;

/**
 * Motion view: the panel that tells why the arm moved as it did at the moment that people look at,
 * and what the line at the caret took of the last run.
 */
public final class MotionView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "motion";

  /** What people read on its tab. */
  public static final String TITLE = text("motion");

  /** Of the names; 75 is that of a column of numbers. */
  private static final int NAME_WIDTH = 95;

  private static final String HINT = text("lookAtAMomentOfThe");

  private final Workbench workbench;
  private final Supplier<Optional<MotionExplanation>> moment;
  private final IntFunction<String> place;
  private final Supplier<Optional<String>> line;
  private final JPanel content = new JPanel(new BorderLayout());
  private final JTextArea text = new JTextArea();
  private final Rows rows = new Rows();
  private final JTable table = new JTable(rows);
  private final JScrollPane numbers = new JScrollPane(table);
  private Optional<MotionExplanation> shown = Optional.empty();
  private PoseForm units = PoseForm.STANDARD;

  /** The numbers, a row each. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Rows extends RowsModel<MotionWords.Row> {
    Rows() {
      super(List.of("", text("planned"), text("actual"), text("difference")));
    }

    @Override
    protected Object cell(MotionWords.Row at, int column) {
      return switch (column) {
        case 0 -> at.name();
        case 1 -> at.planned();
        case 2 -> at.actual();
        default -> at.difference();
      };
    }
  }

  /**
   * The panel.
   *
   * @param moment that people look at, explained; empty for now
   * @param place what a line at that moment is called in a sentence
   * @param line what the line at the caret, or the selected node, took of the last run
   */
  public MotionView(
      Workbench workbench,
      Supplier<Optional<MotionExplanation>> moment,
      IntFunction<String> place,
      Supplier<Optional<String>> line) {
    this.workbench = workbench;
    this.moment = moment;
    this.place = place;
    this.line = line;
    text.setName("motion-text");
    text.getAccessibleContext().setAccessibleName(text("whyTheArmMovedSo"));
    text.setEditable(false);
    text.setLineWrap(true);
    text.setWrapStyleWord(true);
    text.setBorder(BorderFactory.createEmptyBorder(8, 10, 8, 10));
    table.setName("motion-table");
    table.getAccessibleContext().setAccessibleName(text("plannedAndActual"));
    table.setShowGrid(false);
    table.setFillsViewportHeight(true);
    table.setAutoCreateRowSorter(false);
    table.getColumnModel().getColumn(0).setPreferredWidth(NAME_WIDTH);
    JScrollPane words = new JScrollPane(text);
    words.setBorder(BorderFactory.createEmptyBorder());
    numbers.setBorder(BorderFactory.createEmptyBorder());
    numbers.setVisible(false);
    // Tab leaves the table: nothing in its cells can be changed.
    table.setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    table.setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    JPanel both = new JPanel(new MigLayout("insets 0, gap 0, hidemode 3, fill"));
    both.add(words, "w 0:0:, hmin 0, grow, push 40");
    both.add(numbers, "w 0:0:, hmin 0, grow, push 60");
    content.setName("motion-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(both);
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
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    Optional<MotionExplanation> now = moment.get();
    PoseForm form = FormMemory.read(workbench.settings());
    MotionWords words = new MotionWords(form);
    if (!now.equals(shown) || !form.equals(units)) {
      shown = now;
      units = form;
      rows.show(now.map(words::rows).orElse(List.of()));
      numbers.setVisible(now.isPresent());
    }
    String about = now.map(each -> about(words, each)).orElse(HINT);
    String wanted = line.get().map(took -> about + "\n\n" + took).orElse(about);
    if (!wanted.equals(text.getText())) {
      text.setText(wanted);
      text.setCaretPosition(0);
    }
  }

  private String about(MotionWords words, MotionExplanation moment) {
    String limits = words.limits(moment);
    return words.cause(moment)
        + "\n"
        + words.place(moment, place)
        + (limits.isEmpty() ? "" : "\n" + limits);
  }
}
