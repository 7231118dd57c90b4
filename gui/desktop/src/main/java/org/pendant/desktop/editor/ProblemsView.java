package org.pendant.desktop.editor;

import static org.pendant.desktop.editor.EditorTexts.text;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableColumn;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.editor.text.AnalysedText;
import org.pendant.desktop.editor.text.Problem;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.table.RowKeys;
import org.pendant.kit.theme.Palette;

/**
 * Problems view: what is wrong in the program in front. ENTER goes there, alt ENTER offers quick
 * fixes.
 */
public final class ProblemsView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "problems";

  /** What people read on its tab. */
  public static final String TITLE = text("problems");

  private final Workbench workbench;
  private final ScriptEditor editor;
  private final ProblemsModel model = new ProblemsModel();
  private final JTable table = new JTable(model);
  private final EmptyState states = new EmptyState(new JScrollPane(table));
  private final JLabel summary = new JLabel(" ");
  private final JButton fix = new JButton(text("quickFix"));
  private final JPanel content = new JPanel(new BorderLayout());
  private List<Problem> shown = List.of();

  /** The problems of what {@code editor} has in front. */
  public ProblemsView(Workbench workbench, ScriptEditor editor) {
    this.workbench = workbench;
    this.editor = editor;
    content.setName("problems-panel");
    JPanel bar = new JPanel(new MigLayout("insets 4 12 4 12, fillx", "[grow][]"));
    summary.setName("problems-summary");
    fix.setName("problems-fix");
    fix.setToolTipText(text("offerWaysToPutTheSelected"));
    fix.getAccessibleContext().setAccessibleName(text("quickFixOfTheSelectedProblem"));
    fix.setEnabled(false);
    fix.addActionListener(event -> fix());
    bar.add(summary, "growx");
    bar.add(fix);
    content.add(bar, BorderLayout.NORTH);
    content.add(states);
    setUpTable();
    editor.addListener(this::follow);
    states.showNote(text("whatIsWrongInTheProgram"));
    if (editor.current().analysed().isPresent()) {
      follow();
    }
  }

  private void setUpTable() {
    table.setName("problems-table");
    table.getAccessibleContext().setAccessibleName(text("problems"));
    table.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    table.setFillsViewportHeight(true);
    RowKeys.install(table);
    table.setDefaultRenderer(String.class, new Cell());
    table.setAutoCreateRowSorter(true);
    width(0, 72, 88);
    width(1, 48, 64);
    width(3, 96, 160);
    // What is wrong gets the room that there is.
    table.getColumnModel().getColumn(2).setPreferredWidth(800);
    table.getSelectionModel().addListSelectionListener(event -> fix.setEnabled(row() >= 0));
    key("ENTER", this::go);
    key("alt ENTER", this::fix);
    table.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            if (event.getClickCount() == 2) {
              go();
            }
          }
        });
  }

  private void key(String keys, Runnable run) {
    table.registerKeyboardAction(
        event -> run.run(),
        KeyStroke.getKeyStroke(keys),
        JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
  }

  private void width(int column, int least, int width) {
    TableColumn wanted = table.getColumnModel().getColumn(column);
    wanted.setMinWidth(least);
    wanted.setPreferredWidth(width);
    wanted.setMaxWidth(width * 2);
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

  private void follow() {
    List<Problem> problems = editor.current().analysed().map(AnalysedText::problems).orElse(shown);
    if (problems.equals(shown) && !summary.getText().isBlank()) {
      return;
    }
    shown = problems;
    model.replace(problems);
    summary.setText(summary(problems));
    if (problems.isEmpty()) {
      states.showNote(text("noProblemsThisProgramCanRun"));
    } else {
      states.showContent();
    }
  }

  /** How many there are of each kind. */
  static String summary(List<Problem> problems) {
    long errors = problems.stream().filter(Problem::isError).count();
    long warnings = problems.size() - errors;
    return text(
        "errorsAndWarnings",
        text(errors == 0 ? "noErrors" : errors == 1 ? "oneError" : "errors", errors),
        text(warnings == 0 ? "noWarnings" : warnings == 1 ? "oneWarning" : "warnings", warnings));
  }

  private int row() {
    int row = table.getSelectedRow();
    return row < 0 ? -1 : table.convertRowIndexToModel(row);
  }

  private void go() {
    if (row() < 0) {
      return;
    }
    Problem problem = model.row(row());
    if (editor.current().generated() && !editor.component().isShowing()) {
      // The tree shows the node of the line.
      workbench.showSource(problem.line(), problem.column());
      return;
    }
    workbench.show(ScriptEditor.ID);
    editor.current().jump(problem.span());
  }

  private void fix() {
    if (row() >= 0) {
      Problem problem = model.row(row());
      workbench.show(ScriptEditor.ID);
      editor.current().area().requestFocusInWindow();
      editor.current().fixes().open(problem);
    }
  }

  /** Whole messages as tool tips, severities in their colour. */
  @SuppressWarnings("serial") // never written to a stream
  private static final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, false, row, column);
      boolean severity = table.convertColumnIndexToModel(column) == 0;
      setToolTipText(String.valueOf(value));
      if (!selected) {
        boolean error =
            ((ProblemsModel) table.getModel()).row(table.convertRowIndexToModel(row)).isError();
        setForeground(
            !severity ? table.getForeground() : error ? Palette.error() : Palette.warning());
      }
      return this;
    }
  }
}
