package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import java.awt.BorderLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.JSplitPane;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.plan.ParameterTarget;
import org.pendant.sweep.plan.SearchGoal;
import org.pendant.sweep.plan.SweepPlan;

/** Results panel: how far a sweep is, its runs in a table that grows, and a plot of them. */
@SuppressWarnings("serial") // never written to a stream
final class ResultsPanel extends JPanel {
  private static final int PARTS = 1000;
  private static final double TABLE_SHARE = 0.55;
  private static final String BY_OUTCOME = "outcome";

  private final transient SweepPresenter presenter;
  private final RunTable table;
  private final ScatterPlot plot;
  private final JProgressBar bar = new JProgressBar(0, PARTS);
  private final JLabel progress = new JLabel(" ");
  private final JLabel outcomes = new JLabel(" ");
  private final Remark trouble = new Remark("sweep-trouble", Palette::error);
  private final JButton cancel = button("cancel", text("cancel"), text("endsTheSweepWhatIsDone"));
  private final JButton resume = button("go-on", text("resume"), text("goesOnBehindTheLastRow"));
  private final JButton report = button("report", text("openReport"), text("plotsOfAllRunsAsOne"));
  private final JButton open =
      button("open-run", text("openRun"), text("showsTheSelectedRunInThe"));
  private final JCheckBox all = new JCheckBox(text("allColumns"));
  private final JComboBox<String> across = new JComboBox<>();
  private final JComboBox<String> upwards = new JComboBox<>();
  private final JComboBox<String> colored = new JComboBox<>();
  private final JSplitPane split = new JSplitPane();
  private transient Optional<RunRows> shown = Optional.empty();
  private boolean filling;

  /**
   * Nothing yet.
   *
   * @param page opens the page of a report
   */
  ResultsPanel(SweepPresenter presenter, Consumer<Path> page) {
    super(new BorderLayout());
    this.presenter = presenter;
    setName("sweep-results");
    table = new RunTable(presenter::openRun);
    plot = new ScatterPlot(table::select, this::openAt);
    table
        .getSelectionModel()
        .addListSelectionListener(
            event -> {
              plot.mark(table.selected());
              open.setEnabled(table.selected().isPresent());
            });
    cancel.addActionListener(event -> presenter.cancel());
    resume.addActionListener(event -> presenter.start(Sweep.Start.RESUME));
    report.addActionListener(event -> presenter.report(page));
    open.addActionListener(event -> table.openSelected());
    all.setName("sweep-all-columns");
    all.addActionListener(event -> table.setAllColumns(all.isSelected()));
    add(head(), BorderLayout.NORTH);
    add(middle(), BorderLayout.CENTER);
  }

  private void openAt(int place) {
    table.select(place);
    table.openSelected();
  }

  private static JButton button(String name, String text, String tip) {
    JButton button = new JButton(text);
    button.setName("sweep-" + name);
    button.setToolTipText(tip);
    return button;
  }

  private JComponent head() {
    JPanel head = new JPanel(new BorderLayout());
    JPanel row = new JPanel(new WrappingRow(8));
    TitledCard.named(bar, "sweep-bar", text("howFarTheSweepIs"));
    progress.setName("sweep-progress");
    outcomes.setName("sweep-outcomes");
    row.add(cancel);
    row.add(resume);
    row.add(bar);
    row.add(progress);
    row.add(open);
    row.add(report);
    row.add(all);
    row.add(outcomes);
    trouble.setBorder(BorderFactory.createEmptyBorder(0, 10, 6, 10));
    head.add(row, BorderLayout.NORTH);
    head.add(trouble, BorderLayout.SOUTH);
    return head;
  }

  private JComponent middle() {
    JScrollPane rows = new JScrollPane(table);
    rows.setBorder(BorderFactory.createEmptyBorder());
    JPanel plotted = new JPanel(new BorderLayout());
    JPanel axes = new JPanel(new WrappingRow(6));
    axis(axes, text("xAxis"), text("columnForXAxis"), across, "across");
    axis(axes, text("yAxis"), text("columnForYAxis"), upwards, "upwards");
    axis(axes, text("colour"), text("columnForColour"), colored, "colour");
    plotted.add(axes, BorderLayout.NORTH);
    plotted.add(plot, BorderLayout.CENTER);
    split.setName("sweep-split");
    split.setBorder(BorderFactory.createEmptyBorder());
    split.setLeftComponent(rows);
    split.setRightComponent(plotted);
    split.setResizeWeight(TABLE_SHARE);
    split.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            arrange();
          }
        });
    return split;
  }

  private void axis(JPanel axes, String title, String tip, JComboBox<String> choice, String name) {
    JLabel label = new JLabel(title);
    label.setLabelFor(choice);
    TitledCard.named(choice, "sweep-" + name, tip);
    choice.setPrototypeDisplayValue("tool_speed_share");
    choice.addActionListener(
        event -> {
          if (!filling) {
            showPlot();
          }
        });
    JPanel both = new JPanel(new MigLayout("insets 0, gap 6"));
    both.add(label);
    both.add(choice);
    axes.add(both);
  }

  /** The plot is below the table; beside it where the panel is wide. */
  private void arrange() {
    boolean wide = split.getWidth() > 1.6 * split.getHeight();
    int wanted = wide ? JSplitPane.HORIZONTAL_SPLIT : JSplitPane.VERTICAL_SPLIT;
    if (split.getOrientation() != wanted || split.getLastDividerLocation() < 0) {
      split.setOrientation(wanted);
      split.setDividerLocation(wide ? TABLE_SHARE : 1 - TABLE_SHARE);
    }
  }

  private void showPlot() {
    plot.show(shown, column(across), column(upwards), column(colored));
  }

  private int column(JComboBox<String> choice) {
    Object name = choice.getSelectedItem();
    return name == null || name.equals(BY_OUTCOME)
        ? ScatterPlot.BY_OUTCOME
        : shown.map(rows -> rows.column(name.toString())).orElse(ScatterPlot.BY_OUTCOME);
  }

  private void fill(SweepPlan plan, RunRows rows) {
    filling = true;
    across.removeAllItems();
    upwards.removeAllItems();
    colored.removeAllItems();
    colored.addItem(BY_OUTCOME);
    for (int each : rows.numbers()) {
      String name = rows.columns().get(each).name();
      across.addItem(name);
      upwards.addItem(name);
      colored.addItem(name);
    }
    List<Integer> varied =
        rows.numbers().stream().filter(i -> i > 0 && i <= plan.parameters().size()).toList();
    String first = varied.isEmpty() ? "run" : rows.columns().get(varied.getFirst()).name();
    String second =
        varied.size() > 1 && places(plan) ? rows.columns().get(varied.get(1)).name() : "duration";
    across.setSelectedItem(plan.search().isPresent() ? "run" : first);
    upwards.setSelectedItem(plan.search().map(SearchGoal::column).orElse(second));
    colored.setSelectedIndex(0);
    filling = false;
  }

  /** Whether it is about where things are: a map is what people want to see then. */
  private static boolean places(SweepPlan plan) {
    return plan.parameters().stream()
            .filter(
                each ->
                    switch (each.target()) {
                      case ParameterTarget.BasePlace _,
                          ParameterTarget.FeaturePlace _,
                          ParameterTarget.ObjectPlace _ ->
                          true;
                      case ParameterTarget.Variable _,
                          ParameterTarget.CallArgument _,
                          ParameterTarget.MoveFactor _,
                          ParameterTarget.Slider _,
                          ParameterTarget.Load _,
                          ParameterTarget.InputLevel _,
                          ParameterTarget.InputTime _,
                          ParameterTarget.Seed _,
                          ParameterTarget.RobotModel _ ->
                          false;
                    })
            .count()
        > 1;
  }

  /** Opens the selected run. */
  void openSelected() {
    table.openSelected();
  }

  /** Whether a run is selected. */
  boolean selected() {
    return table.selected().isPresent();
  }

  /** Keys go to the rows. */
  void focus() {
    table.requestFocusInWindow();
  }

  /** Shows what has come. */
  void showRows() {
    Optional<SweepPresenter.Shown> now = presenter.shown();
    Optional<RunRows> rows = now.map(SweepPresenter.Shown::rows);
    boolean others = !Objects.equals(rows, shown);
    shown = rows;
    if (others) {
      now.ifPresent(each -> fill(each.plan(), each.rows()));
    }
    table.nameLinesBy(now.flatMap(SweepPresenter.Shown::nodes));
    table.show(rows, now.map(each -> each.plan().parameters().size()).orElse(0));
    showPlot();
    boolean runs = presenter.runs();
    cancel.setVisible(runs);
    cancel.setEnabled(presenter.running().filter(RunningSweep::cancelled).isEmpty());
    long rowsThere = rows.map(each -> (long) each.size()).orElse(0L);
    resume.setVisible(!runs && presenter.canResume());
    resume.setEnabled(presenter.whyNotStart().isEmpty());
    report.setEnabled(rowsThere > 0);
    open.setEnabled(table.selected().isPresent());
    Optional<RunningSweep> sweep =
        presenter
            .running()
            .filter(each -> now.isEmpty() || each.order().folder().equals(now.get().folder()));
    bar.setVisible(runs);
    sweep.ifPresent(
        each ->
            bar.setValue(
                each.size() == 0
                    ? 0
                    : (int) (PARTS * Math.min(each.done(), each.size()) / each.size())));
    progress.setText(
        sweep
            .map(SweepWords::progress)
            .orElseGet(() -> rows.isPresent() ? text("runCount", rowsThere) : text("noRunsYet")));
    outcomes.setText(rows.map(each -> SweepWords.outcomes(each.outcomes())).orElse(" "));
    outcomes.setToolTipText(
        rows.filter(each -> each.size() >= RunRows.MAX_ROWS).isPresent()
            ? text("theWindowShowsTheFirstRuns", RunRows.MAX_ROWS)
            : null);
    trouble.say(presenter.trouble());
  }
}
