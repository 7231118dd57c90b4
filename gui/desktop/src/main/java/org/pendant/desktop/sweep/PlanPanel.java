package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Collectors;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.SpinnerNumberModel;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.form.EntryField;
import org.pendant.kit.form.Remark;
import org.pendant.kit.layout.CardColumns;
import org.pendant.kit.layout.SettledScroll;
import org.pendant.kit.layout.ShownFocus;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.layout.WideContent;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.Palette;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.plan.SamplingMethod;

/** Plan panel: the form in which people say what a sweep varies, and start it. */
@SuppressWarnings("serial") // never written to a stream
final class PlanPanel extends JPanel {
  private static final int MAX_WORKERS = 1024;
  private static final int GAP = 10;
  private static final int REST_WIDTH = 300;
  private static final int WIDE = 780;
  private static final String LEFT_TO_RIGHT = "[][grow, fill]";
  private static final List<String> GOALS =
      List.of(
          "duration",
          "torque_share",
          "speed_share",
          "tool_speed",
          "energy",
          "singularity",
          "joint_limit",
          "plane",
          "force");

  private final transient SweepPresenter presenter;
  private final ParameterTable table;
  private final transient Map<String, JComponent> fields = new HashMap<>();
  private final transient List<Runnable> shows = new ArrayList<>();
  private final JTextField filter = new JTextField(16);
  private final JCheckBox chosenOnly = new JCheckBox(text("onlyTicked"));
  private final JLabel program = new JLabel();
  private final JLabel around = new JLabel();
  private final JComboBox<SamplingMethod> method = new JComboBox<>(SamplingMethod.values());
  private final JLabel about = new JLabel();
  private final JPanel counted = row();
  private final JPanel search =
      new JPanel(new MigLayout("insets 0, gap 8 4, wrap 2", LEFT_TO_RIGHT));
  private final JLabel count = new JLabel();
  private final Remark wrong = new Remark("sweep-wrong", this::wrongColor);
  private final JButton start = button("start", text("start"), text("savesThePlanAndRunsIt"));
  private final JButton resume = button("resume", text("resume"), text("goesOnBehindTheRowsThat"));
  private final JButton save =
      button("save", text("savePlan"), text("savesThePlanWithoutRunningIt"));
  private final WideContent sheet = new WideContent(new CardColumns(GAP, REST_WIDTH));
  private final JPanel rest =
      new JPanel(new MigLayout("insets 0, gap 10 10, wrap", "[grow, fill]"));
  private final JComponent parameters;
  private boolean wide;
  private boolean sure;
  private boolean showing;

  PlanPanel(SweepPresenter presenter) {
    super(new BorderLayout());
    this.presenter = presenter;
    table = new ParameterTable(presenter);
    setName("sweep-plan");
    parameters = parametersCard();
    sheet.setLayout(new MigLayout("insets 10, gap 10", "[grow, fill][]", "[top]"));
    rest.setOpaque(false);
    rest.add(variantsCard());
    rest.add(runCard());
    rest.add(programCard());
    JScrollPane scroll = new SettledScroll(sheet);
    scroll.getVerticalScrollBar().setUnitIncrement(16);
    scroll
        .getViewport()
        .addComponentListener(
            new ComponentAdapter() {
              @Override
              public void componentResized(ComponentEvent event) {
                arrange(scroll.getViewport().getWidth() >= UIScale.scale(WIDE));
              }
            });
    arrange(true);
    add(scroll, BorderLayout.CENTER);
    add(foot(), BorderLayout.SOUTH);
  }

  /** The parameters have the height of the panel beside the rest, or are above it. */
  private void arrange(boolean beside) {
    if (sheet.getComponentCount() > 0 && beside == wide) {
      return;
    }
    wide = beside;
    sheet.removeAll();
    sheet.add(parameters, beside ? "grow, push, wmin 300" : "growx, wrap");
    sheet.add(rest, beside ? "width " + REST_WIDTH + "!, top" : "growx");
    sheet.revalidate();
  }

  private static JButton button(String name, String text, String tip) {
    JButton button = new JButton(text);
    button.setName("sweep-" + name);
    button.setToolTipText(tip);
    return button;
  }

  private static JPanel row() {
    JPanel row = new JPanel(new MigLayout("insets 0, gap 8 4", ""));
    row.setOpaque(false);
    return row;
  }

  private JComponent programCard() {
    TitledCard card = new TitledCard("program", text("program"), LEFT_TO_RIGHT);
    program.setName("sweep-program");
    around.setName("sweep-around");
    JComboBox<String> robot = new JComboBox<>();
    robot.addItem("");
    SweepPresenter.arms().forEach(robot::addItem);
    TitledCard.named(robot, "sweep-robot", text("theArmEmptyForThatOf"));
    robot.addActionListener(
        event ->
            typed(
                draft ->
                    draft.with(
                        new PlanDraft.Files(
                            draft.files().plan(),
                            draft.files().program(),
                            draft.files().installation(),
                            draft.files().scene(),
                            String.valueOf(robot.getSelectedItem())))));
    shows.add(
        () -> {
          String wanted = draft().files().robot();
          // a plan may name the file of an arm
          robot.setSelectedItem(wanted);
          if (!wanted.equals(robot.getSelectedItem())) {
            robot.addItem(wanted);
            robot.setSelectedItem(wanted);
          }
        });
    card.add(new JLabel(text("programFile")));
    card.add(program, "wrap, wmin 0");
    card.add(new JLabel(text("programWith")));
    card.add(around, "wrap, wmin 0");
    card.add(label(text("arm"), robot));
    card.add(robot, "wrap, growx 0");
    fields.put("program", program);
    return card;
  }

  private JComponent parametersCard() {
    TitledCard card = new TitledCard("what-varies", text("whatVaries"), "[grow, fill]");
    if (card.getLayout() instanceof MigLayout layout) {
      layout.setRowConstraints("[][][grow, fill]");
    }
    filter.putClientProperty("JTextField.placeholderText", text("filterParameters"));
    filter.putClientProperty("JTextField.showClearButton", true);
    TitledCard.named(filter, "sweep-filter", text("showParametersWithThisText"));
    filter.getDocument().addDocumentListener(new Typed(this::filterChanged));
    chosenOnly.setName("sweep-only-ticked");
    chosenOnly.setOpaque(false);
    chosenOnly.addActionListener(event -> filterChanged());
    JPanel bar = row();
    bar.add(filter);
    bar.add(chosenOnly);
    card.add(bar, "wmin 0");
    JScrollPane scroll = new JScrollPane(table);
    scroll.setPreferredSize(new Dimension(460, 230));
    ShownFocus.of(table, scroll);
    card.add(scroll, "wmin 0, hmin 120");
    return card;
  }

  private void filterChanged() {
    table.filter(filter.getText(), chosenOnly.isSelected());
  }

  private JComponent variantsCard() {
    TitledCard card = new TitledCard("variants", text("variants"), "[grow, fill]");
    TitledCard.named(method, "sweep-method", text("howTheValuesAreChosen"));
    method.setRenderer(new MethodCell());
    method.addActionListener(
        event ->
            typed(
                draft ->
                    draft.with(
                        draft.sampling().withMethod((SamplingMethod) method.getSelectedItem()))));
    shows.add(() -> method.setSelectedItem(draft().sampling().method()));
    card.add(method);
    about.setForeground(Palette.quiet());
    about.setName("sweep-method-about");
    card.add(about, "wmin 0");
    counted.add(
        label(
            text("runsLabel"),
            field(
                "runs", 7, d -> d.sampling().runs(), (d, t) -> d.with(d.sampling().withRuns(t)))));
    counted.add(fields.get("runs"));
    JTextField seed =
        field(
            "sampling-seed",
            5,
            d -> d.sampling().seed(),
            (d, t) -> d.with(d.sampling().withSeed(t)));
    counted.add(label(text("seed"), seed));
    counted.add(seed);
    card.add(counted, "wmin 0");
    search.setOpaque(false);
    JComboBox<String> direction =
        new JComboBox<>(new String[] {text("searchLeast"), text("searchLargest")});
    TitledCard.named(direction, "sweep-direction", text("whetherTheSearchWantsItSmall"));
    direction.addActionListener(
        event ->
            typed(
                draft ->
                    draft.with(draft.sampling().withMaximize(direction.getSelectedIndex() == 1))));
    shows.add(() -> direction.setSelectedIndex(draft().sampling().maximize() ? 1 : 0));
    JComboBox<String> goal = new JComboBox<>(GOALS.toArray(String[]::new));
    goal.setEditable(true);
    TitledCard.named(goal, "sweep-goal", text("aColumnOfTheResults"));
    goal.addActionListener(
        event ->
            typed(
                draft ->
                    draft.with(
                        draft.sampling().withColumn(String.valueOf(goal.getSelectedItem())))));
    shows.add(() -> goal.setSelectedItem(draft().sampling().column()));
    fields.put("goal", goal);
    search.add(direction, "growx 0");
    search.add(goal, "wmin 60");
    JTextField limits =
        field(
            "limits", 20, d -> d.sampling().limits(), (d, t) -> d.with(d.sampling().withLimits(t)));
    limits.setToolTipText(text("whatMustHoldOfARun"));
    search.add(label(text("limits"), limits), "span");
    search.add(limits, "span, wmin 60");
    JTextField stall =
        field("stall", 5, d -> d.sampling().stall(), (d, t) -> d.with(d.sampling().withStall(t)));
    stall.setToolTipText(text("theSearchEndsAfterSoMany"));
    search.add(label(text("endsAfter"), stall), "span");
    JPanel generations = row();
    generations.add(stall);
    generations.add(new JLabel(text("idleGenerations")));
    search.add(generations, "span, wmin 0");
    card.add(search, "wmin 0");
    return card;
  }

  private JComponent runCard() {
    TitledCard card = new TitledCard("each-run", text("eachRun"), LEFT_TO_RIGHT);
    JTextField limit =
        field(
            "time-limit",
            7,
            d -> d.settings().timeLimit(),
            (d, t) -> d.with(d.settings().withTimeLimit(t)));
    limit.setToolTipText(text("robotTimeAfterWhichARun"));
    JPanel atMost = row();
    atMost.add(limit);
    atMost.add(new JLabel("s"));
    card.add(label(text("longestRunAtMost"), limit));
    card.add(atMost, "wrap, wmin 0");
    JCheckBox ideal = new JCheckBox(text("idealArm"));
    ideal.setToolTipText(text("anArmThatIsAlwaysExactly"));
    check(
        ideal,
        "ideal",
        d -> d.settings().idealArm(),
        (d, on) -> d.with(d.settings().withIdealArm(on)));
    JCheckBox noise = new JCheckBox(text("noiseOfSensors"));
    noise.setToolTipText(text("sensorsThatErrAsThoseOf"));
    check(noise, "noise", d -> d.settings().noise(), (d, on) -> d.with(d.settings().withNoise(on)));
    card.add(new JLabel(text("arm")));
    card.add(ideal, "wrap, wmin 0");
    card.add(noise, "span, wmin 0");
    texts(
        card,
        "variables",
        text("tellVariables"),
        text("globalVariablesWhoseLastValuesBecome"),
        d -> d.settings().variables(),
        (d, t) -> d.with(d.settings().withVariables(t)));
    texts(
        card,
        "fixed",
        text("posesInTheCell"),
        text("variablesWhosePosesStayWhereThey"),
        d -> d.settings().fixed(),
        (d, t) -> d.with(d.settings().withFixed(t)));
    texts(
        card,
        "inputs",
        text("inputsAtFirst"),
        text("levelsFromTheStartSuchAs"),
        d -> d.settings().inputs(),
        (d, t) -> d.with(d.settings().withInputs(t)));
    return card;
  }

  private void texts(
      TitledCard card,
      String name,
      String title,
      String tip,
      Function<PlanDraft, String> shown,
      BiFunction<PlanDraft, String, PlanDraft> taken) {
    JTextField field = field(name, 16, shown, taken);
    field.setToolTipText(tip);
    field.putClientProperty("JTextField.placeholderText", text("nothingTyped"));
    card.add(label(title, field));
    card.add(field, "wrap, wmin 0");
  }

  private static JLabel label(String text, JComponent of) {
    JLabel label = new JLabel(text);
    label.setLabelFor(of);
    return label;
  }

  private JTextField field(
      String name,
      int columns,
      Function<PlanDraft, String> shown,
      BiFunction<PlanDraft, String, PlanDraft> taken) {
    JTextField field = ShownFocus.of(new JTextField(columns));
    TitledCard.named(field, "sweep-" + name, name.replace('-', ' '));
    field
        .getDocument()
        .addDocumentListener(new Typed(() -> typed(draft -> taken.apply(draft, field.getText()))));
    shows.add(
        () -> {
          if (!field.getText().equals(shown.apply(draft()))) {
            field.setText(shown.apply(draft()));
          }
        });
    fields.put(name, field);
    return field;
  }

  private void check(
      JCheckBox box,
      String name,
      Function<PlanDraft, Boolean> shown,
      BiFunction<PlanDraft, Boolean, PlanDraft> taken) {
    box.setName("sweep-" + name);
    box.setOpaque(false);
    box.addActionListener(event -> typed(draft -> taken.apply(draft, box.isSelected())));
    shows.add(() -> box.setSelected(shown.apply(draft())));
  }

  private PlanDraft draft() {
    return presenter.draft().orElseThrow();
  }

  private void typed(UnaryOperator<PlanDraft> how) {
    if (!showing) {
      sure = false;
      presenter.change(how);
    }
  }

  private JComponent foot() {
    JPanel foot = new JPanel(new BorderLayout());
    foot.setBorder(BorderFactory.createMatteBorder(1, 0, 0, 0, Palette.line()));
    JPanel words = new JPanel(new MigLayout("insets 6 10 0 10", "[grow, fill]"));
    words.add(wrong, Remark.LAYOUT);
    JPanel bar = new JPanel(new WrappingRow(8));
    count.setName("sweep-count");
    EntryField plan =
        new EntryField(18, PlanPanel::refusal, text -> typed(draft -> withPlan(draft, text)));
    TitledCard.named(plan, "sweep-plan-file", text("theFileOfThePlan"));
    plan.withTip(text("theFileOfThePlanWhich"));
    shows.add(() -> plan.follow(nameOf(draft().files())));
    fields.put("plan-file", plan);
    JButton choose = button("choose", "\u2026", text("chooseWhereThePlanIsSaved"));
    choose.getAccessibleContext().setAccessibleName(text("chooseWhereThePlanIsSaved"));
    choose.addActionListener(event -> choose());
    JSpinner workers = new JSpinner(new SpinnerNumberModel(presenter.workers(), 1, MAX_WORKERS, 1));
    TitledCard.named(workers, "sweep-workers", text("howManyRunsThereAreAt"));
    workers.addChangeListener(event -> presenter.setWorkers((Integer) workers.getValue()));
    start.addActionListener(event -> start());
    resume.addActionListener(event -> presenter.start(Sweep.Start.RESUME));
    save.addActionListener(event -> presenter.save());
    bar.add(count);
    bar.add(label(text("plan"), plan));
    bar.add(plan);
    bar.add(choose);
    bar.add(label(text("workers"), workers));
    bar.add(workers);
    bar.add(save);
    bar.add(resume);
    bar.add(start);
    foot.add(words, BorderLayout.NORTH);
    foot.add(bar, BorderLayout.CENTER);
    return foot;
  }

  /** A plan beside its program goes by its name alone. */
  private static String nameOf(PlanDraft.Files files) {
    return Objects.equals(files.plan().getParent(), files.program().getParent())
        ? files.plan().getFileName().toString()
        : files.plan().toString();
  }

  private static String refusal(String text) {
    try {
      return Path.of(text.strip()).getFileName() == null || text.isBlank()
          ? text("thePlanNeedsTheNameOf")
          : "";
    } catch (InvalidPathException e) {
      return text("notAFileName", text, e.getReason());
    }
  }

  private static PlanDraft withPlan(PlanDraft draft, String text) {
    String name = text.strip();
    Path plan =
        draft
            .files()
            .program()
            .resolveSibling(name.endsWith(".toml") ? name : name + ".toml")
            .normalize();
    return draft.with(
        new PlanDraft.Files(
            plan,
            draft.files().program(),
            draft.files().installation(),
            draft.files().scene(),
            draft.files().robot()));
  }

  private void choose() {
    SaveDialog.ask(
        this,
        new SaveRequest(text("saveThePlanAs"), draft().files().plan(), List.of("toml"), List.of()),
        chosen -> chosen.ifPresent(file -> typed(draft -> withPlan(draft, file.toString()))));
  }

  /** Where there are results already, the button is to be pressed twice. */
  void start() {
    if (!presenter.whyNotStart().isEmpty()) {
      show(presenter.whyNotStart());
      return;
    }
    if (presenter.rowsThere() > 0 && !sure) {
      sure = true;
      showDraft();
      return;
    }
    sure = false;
    presenter.start(presenter.fromTheFirst());
  }

  /** That nothing is chosen yet is no mistake. */
  private Color wrongColor() {
    boolean nothing =
        presenter == null
            || (presenter.trouble().isEmpty()
                && presenter.errors().size() == 1
                && presenter.draft().filter(each -> each.chosen().isEmpty()).isPresent());
    return nothing ? Palette.quiet() : Palette.error();
  }

  private void show(String why) {
    wrong.say(why);
  }

  /** Shows the draft as it is now. */
  void showDraft() {
    if (presenter.draft().isEmpty()) {
      return;
    }
    showing = true;
    shows.forEach(Runnable::run);
    showing = false;
    PlanDraft draft = draft();
    program.setText(draft.files().program().getFileName().toString());
    program.setToolTipText(draft.files().program().toString());
    String with =
        List.of(draft.files().installation(), draft.files().scene()).stream()
            .flatMap(Optional::stream)
            .map(each -> each.getFileName().toString())
            .collect(Collectors.joining(", "));
    around.setText(with.isEmpty() ? text("noInstallationNoScene") : with);
    SamplingMethod now = draft.sampling().method();
    about.setText("<html>" + MethodCell.about(now));
    counted.setVisible(now.counted());
    search.setVisible(now == SamplingMethod.SEARCH);
    table.showDraft();
    Map<String, String> errors = presenter.errors();
    fields.forEach((name, field) -> mark(field, errors.get(name)));
    String trouble = presenter.trouble();
    wrong.say(
        presenter.reading()
            ? ""
            : trouble.isEmpty() ? errors.values().stream().findFirst().orElse("") : trouble);
    count.setText(words(draft));
    boolean ready = presenter.whyNotStart().isEmpty();
    long rows = presenter.rowsThere();
    start.setEnabled(ready);
    start.setText(
        rows == 0 ? text("start") : sure ? text("replaceResults", rows) : text("startAnew"));
    resume.setVisible(presenter.canResume());
    resume.setEnabled(ready);
    resume.setText(text("resumeBehind", rows));
    save.setEnabled(
        presenter.check().plan().isPresent()
            && !presenter.runs()
            && !errors.containsKey("plan-file"));
  }

  private static void mark(JComponent field, String error) {
    if (field instanceof JLabel label) {
      label.setForeground(error == null ? null : Palette.error());
    } else {
      field.putClientProperty("JComponent.outline", error == null ? null : "error");
    }
    field.getAccessibleContext().setAccessibleDescription(error);
  }

  private String words(PlanDraft draft) {
    return presenter
        .check()
        .plan()
        .map(
            plan ->
                SweepWords.runs(plan.size(), draft.sampling().method() == SamplingMethod.SEARCH))
        .orElseGet(() -> text("noRunsInPlan"));
  }
}
