package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import javax.swing.SwingConstants;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.background.Background;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.theme.HtmlLabel;
import org.pendant.kit.theme.Markup;
import org.pendant.kit.theme.Palette;
import org.pendant.models.arm.ArmLibrary;

/** Sweep view: people plan a sweep of the open program, run it and look at its runs. */
public final class SweepView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "sweep";

  private static final int LOOK_MS = 250;
  private static final String PLAN = "plan";
  private static final String RESULTS = "results";
  private static final String EMPTY = "empty";

  private final Workbench workbench;
  private final Programs programs;
  private final ActiveInstallation installation;
  private final SceneDraft scene;
  private final SweepPresenter presenter;
  private final Consumer<Path> page;
  private final CardLayout cards = new CardLayout();
  private final JPanel middle = new JPanel(cards);
  private final JPanel content = new JPanel(new BorderLayout());
  private final JToggleButton planTab = new JToggleButton(text("plan"), true);
  private final JToggleButton resultsTab = new JToggleButton(text("results"));
  private final JButton fresh = button("new", text("sweepOfThisProgram"), "");
  private final JButton open;
  private final JLabel note = new HtmlLabel(SwingConstants.CENTER);
  private final Timer look = Faults.timer(LOOK_MS, this::look);
  private Optional<SavedProgram> seen = Optional.empty();
  private Optional<Panels> panels = Optional.empty();
  private boolean resultsWanted;
  private String shownWhy = "";

  /** What is made with the first plan: windows that open without one open earlier. */
  private record Panels(PlanPanel plan, ResultsPanel results) {}

  /**
   * The panel; it adds its actions to the workbench.
   *
   * @param recording opens a recording in the window
   * @param choose asks for the file of a plan
   * @param page opens a page of HTML
   */
  public SweepView(
      Workbench workbench,
      Programs programs,
      ActiveInstallation installation,
      SceneDraft scene,
      Consumer<Path> recording,
      Runnable choose,
      Consumer<Path> page) {
    this.workbench = workbench;
    this.programs = programs;
    this.installation = installation;
    this.scene = scene;
    presenter = new SweepPresenter(this::subject, Background::run, workbench::notify, recording);
    this.page = page;
    open = button("open", text("openPlan"), text("opensTheFileOfAPlan"));
    open.addActionListener(event -> choose.run());
    fresh.addActionListener(event -> planThis());
    content.setName("sweep-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(head(), BorderLayout.NORTH);
    content.add(middle, BorderLayout.CENTER);
    middle.add(empty(), EMPTY);
    presenter.whenChanged(this::show);
    declareActions(choose);
    show();
  }

  private static JButton button(String name, String text, String tip) {
    JButton button = new JButton(text);
    button.setName("sweep-" + name);
    button.setToolTipText(tip.isEmpty() ? text : tip);
    return button;
  }

  private JComponent head() {
    JPanel head = new JPanel(new WrappingRow(6));
    ButtonGroup tabs = new ButtonGroup();
    planTab.setName("sweep-tab-plan");
    resultsTab.setName("sweep-tab-results");
    for (JToggleButton each : List.of(planTab, resultsTab)) {

      tabs.add(each);
      head.add(each);
    }
    planTab.addActionListener(event -> showResults(false));
    resultsTab.addActionListener(event -> showResults(true));
    head.add(fresh);
    head.add(open);
    return head;
  }

  private JComponent empty() {
    JPanel panel =
        new JPanel(new MigLayout("insets 12, wrap 1, align center center", "[center, grow]"));
    note.setName("sweep-note");
    panel.add(note, "growx, wmin 0");
    return panel;
  }

  private void declareActions(Runnable choose) {
    var actions = workbench.actions();
    actions.add(
        new Action(
            ID + ".new",
            text("sweepPlanOneOfThisProgram"),
            "",
            () -> presenter.whyNoPlan().isEmpty(),
            this::planThis));
    actions.add(Action.of(ID + ".open", text("sweepOpenAPlan"), "", choose));
    actions.add(
        new Action(
            ID + ".start",
            text("sweepStart"),
            "",
            () -> presenter.whyNotStart().isEmpty(),
            () -> {
              workbench.show(ID);
              panels.ifPresent(each -> each.plan().start());
            }));
    actions.add(
        new Action(ID + ".cancel", text("sweepCancel"), "", presenter::runs, presenter::cancel));
    actions.add(
        new Action(
            ID + ".open-run",
            text("sweepOpenTheSelectedRun"),
            "",
            () -> panels.filter(each -> each.results().selected()).isPresent(),
            () -> panels.ifPresent(each -> each.results().openSelected())));
    actions.add(
        new Action(
            ID + ".report",
            text("sweepOpenTheReport"),
            "",
            () -> presenter.shown().isPresent(),
            () -> presenter.report(page)));
  }

  /** Begins a plan of the program in front. */
  private void planThis() {
    workbench.show(ID);
    showResults(false);
    presenter.planThis();
  }

  /** Opens the file of a plan. */
  public void open(Path file) {
    workbench.show(ID);
    presenter.open(file);
    showResults(false);
  }

  /** Whether a file is called as plans are. */
  public static boolean isPlan(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".toml");
  }

  private void showResults(boolean wanted) {
    resultsWanted = wanted;
    show();
    if (wanted) {
      focusResults();
    }
  }

  private void focusResults() {
    panels.ifPresent(each -> each.results().focus());
  }

  private SweepSubject subject() {
    ProgramDocument front = programs.current();
    String robot = workbench.session().options().robotId();
    List<Path> unsaved = new ArrayList<>();
    programs.all().stream()
        .filter(ProgramDocument::modified)
        .forEach(each -> each.file().ifPresent(unsaved::add));
    for (ProgramDocument each : List.of(installation.document(), scene.document())) {
      if (each.modified()) {
        each.file().ifPresent(unsaved::add);
      }
    }
    return new SweepSubject(
        front.name(),
        front.file(),
        installation.document().file(),
        scene.document().file(),
        ArmLibrary.find(robot).isPresent() ? robot : "",
        unsaved);
  }

  private void look() {
    presenter.look();
    if (!presenter.runs()) {
      look.stop();
    }
  }

  private void show() {
    if (presenter.runs() && !look.isRunning()) {
      look.start();
      resultsWanted = true;
      EventQueue.invokeLater(this::focusResults);
    }
    boolean there = presenter.draft().isPresent();
    String why = presenter.trouble().isEmpty() ? presenter.whyNoPlan() : presenter.trouble();
    note.setText(
        "<html><center>"
            + Markup.escaped(
                presenter.reading()
                    ? text("reading")
                    : why.isEmpty() ? text("runsTheProgramInThousandsOf") : why));
    note.setForeground(presenter.trouble().isEmpty() ? Palette.quiet() : Palette.error());
    planTab.setVisible(there);
    resultsTab.setVisible(there);
    planTab.setSelected(!resultsWanted);
    resultsTab.setSelected(resultsWanted);
    fresh.setEnabled(presenter.whyNoPlan().isEmpty());
    fresh.setToolTipText(
        presenter.whyNoPlan().isEmpty()
            ? text("beginsAPlanOf", programs.current().name())
            : presenter.whyNoPlan());
    open.setEnabled(!presenter.runs());
    if (there && panels.isEmpty()) {
      Panels made = new Panels(new PlanPanel(presenter), new ResultsPanel(presenter, page));
      middle.add(made.plan(), PLAN);
      middle.add(made.results(), RESULTS);
      panels = Optional.of(made);
    }
    cards.show(middle, !there ? EMPTY : resultsWanted ? RESULTS : PLAN);
    panels.ifPresent(
        each -> {
          each.plan().showDraft();
          each.results().showRows();
        });
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("sweep");
  }

  @Override
  public JComponent component() {
    return content;
  }

  /** What the program offers may be other things once it is saved. */
  @Override
  public void refresh(ControllerState state) {
    Optional<SavedProgram> disk =
        presenter
            .draft()
            .flatMap(each -> programs.of(each.files().program()))
            .flatMap(ProgramDocument::onDisk);
    if (!disk.equals(seen)) {
      seen = disk;
      presenter.readOffers();
    }
    // a program may have been saved, closed or changed meanwhile
    String now = presenter.whyNoPlan() + presenter.whyNotStart();
    if (!now.equals(shownWhy)) {
      shownWhy = now;
      show();
    }
  }
}
