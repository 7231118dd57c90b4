package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.layout.ButtonKeys;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantRun;
import org.pendant.script.vm.Program;

/**
 * What-if view: the panel in which people run the last program once more in several variants and
 * compare cycle time, torque, speed and energy.
 */
public final class WhatIfView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "whatif";

  private static final String WAYS = "whatif.ways";
  private static final String GHOSTS = "whatif.ghosts";
  private static final int MAX_S = 600;
  private static final int FIELD_COLUMNS = 4;

  private final Workbench workbench;
  private final Supplier<Optional<ControllerState>> past;
  private final WhatIfPresenter presenter;
  private final VariantTableModel model;
  private final VariantTable table;
  private final JPanel content = new JPanel(new BorderLayout());
  private final JLabel refused = new JLabel();
  private final JLabel from = new JLabel();
  private final JButton run = button("run", text("runFromTheStart"), "");
  private final JButton cancel = button("cancel", text("cancel"), text("givesUpWhatRuns"));
  private final JButton add = button("add", "+", text("addsAVariantIns"), text("addAVariant"));
  private final JButton remove =
      button("remove", "\u2212", text("removesTheSelectedVariantDel"), text("removeTheVariant"));
  private final JButton clear =
      button("clear", text("clear"), text("forgetsWhatCameOfThem"), text("clearTheResults"));
  private final JCheckBox ways = new JCheckBox(text("waysIn3d"));
  private final JTextField most = new JTextField(Integer.toString(MAX_S), FIELD_COLUMNS);
  private final JCheckBox ghosts = new JCheckBox(text("ghostsIn3d"));
  private final BooleanSupplier ofFile;
  private final RanProgram program;

  private VariantSights sights = new VariantSights(List.of(), List.of(), -1, row -> 0);

  /** Whose variants they are; empty before the first. */
  private volatile Optional<SessionMember> ranBy = Optional.empty();

  /** Of which program they are; empty before the first. */
  private Optional<VariantSubject> subject = Optional.empty();

  /** The program that ran last. */
  public interface RanProgram {
    /** The one that was started last; empty where it is none that is open. */
    Optional<ProgramDocument> started();

    /** The one that people look at. */
    ProgramDocument front();

    /**
     * What a line of a program is called in a sentence.
     *
     * @param line of the program as it is edited now, or else of what was started last
     */
    String place(ProgramDocument of, int line, boolean edited);

    /** Compiles it as it is edited now; one of both follows, in the dispatch thread. */
    void compile(Consumer<Program> then, Consumer<String> failed);
  }

  /**
   * The panel.
   *
   * @param past the moment that people look at; empty for now
   * @param ofFile whether that is of a file
   */
  public WhatIfView(
      Workbench workbench,
      Supplier<Optional<ControllerState>> past,
      BooleanSupplier ofFile,
      RanProgram program) {
    this.workbench = workbench;
    this.program = program;
    this.past = past;
    this.ofFile = ofFile;
    presenter =
        new WhatIfPresenter(
            new SessionSource(),
            () -> start(ofFile.getAsBoolean()),
            EventQueue::invokeLater,
            work -> Thread.ofPlatform().daemon().name("what-if").start(work),
            this::show);
    model =
        new VariantTableModel(presenter, () -> FormMemory.read(workbench.settings()), this::place);
    table = new VariantTable(presenter, model, refused);
    table.getSelectionModel().addListSelectionListener(event -> selectionChanged());
    JScrollPane scroll = new JScrollPane(table);
    scroll.setBorder(BorderFactory.createEmptyBorder());
    refused.setName("whatif-refusal");
    refused.setBorder(BorderFactory.createEmptyBorder(4, 8, 4, 8));
    refused.setVisible(false);
    content.setName("whatif-view");
    content.getAccessibleContext().setAccessibleName(title());
    content.add(bar(), BorderLayout.NORTH);
    content.add(scroll, BorderLayout.CENTER);
    content.add(refused, BorderLayout.SOUTH);
    declareActions();
    show();
  }

  private final class SessionSource implements WhatIfPresenter.Source {
    @Override
    public VariantRun begin(OptionalLong frame, Variant variant, VariantLimits limits)
        throws RerunRefused {
      return workbench.session().variant(ranBy.orElseThrow(), frame, variant, limits);
    }

    @Override
    public void compile(Consumer<Program> then, Consumer<String> failed) {
      program.compile(then, failed);
    }
  }

  private WhatIfPresenter.Start start(boolean ofFile) {
    Optional<ControllerState> at = past.get();
    if (ofFile) {
      return new WhatIfPresenter.Start(
          OptionalLong.empty(), text("runFromHere"), text("aRecordingOfAFileCannot"));
    }
    if (at.isPresent()) {
      long frame = at.get().frame();
      String why =
          at.get().program().line() > 0
              ? workbench.session().branchRefusal(frame).orElse("")
              : text("noProgramRanAtTheMoment");
      return new WhatIfPresenter.Start(
          OptionalLong.of(frame),
          String.format(Locale.ROOT, text("runFromMoment"), at.get().timeS()),
          why);
    }
    return new WhatIfPresenter.Start(
        OptionalLong.empty(),
        text("runFromTheStart"),
        workbench.session().programKnown() ? "" : text("noProgramHasRunYet"));
  }

  private String place(int line, boolean edited) {
    ProgramDocument of =
        subject.map(each -> each.ran().orElse(each.front())).orElseGet(program::front);
    return program.place(of, line, edited);
  }

  private static JButton button(String name, String text, String tip) {
    return button(name, text, tip, text);
  }

  private static JButton button(String name, String text, String tip, String accessibleName) {
    JButton button = new JButton(text);
    button.setName("whatif-" + name);
    button.setToolTipText(tip.isEmpty() ? text : tip);
    button.getAccessibleContext().setAccessibleName(accessibleName);
    return button;
  }

  private JPanel bar() {
    JPanel bar = new JPanel(new WrappingRow(6));
    run.addActionListener(event -> run());
    cancel.addActionListener(event -> presenter.cancel());
    add.addActionListener(event -> presenter.add());
    remove.addActionListener(event -> presenter.remove(table.getSelectedRow()));
    clear.addActionListener(event -> presenter.clear());
    ways.setName("whatif-ways");
    ways.setToolTipText(text("showsIn3dWhereTheTool"));
    ways.addActionListener(event -> set(WAYS, ways.isSelected()));
    ghosts.setName("whatif-ghosts");
    ghosts.setToolTipText(text("whilePeopleLookBackShowsIn"));
    ghosts.addActionListener(event -> set(GHOSTS, ghosts.isSelected()));
    from.setName("whatif-from");
    most.setName("whatif-most");
    most.setToolTipText(text("aProgramThatStillRunsAfter"));
    most.getAccessibleContext().setAccessibleName(text("longestRobotTimeOfAVariant"));
    most.getDocument().addDocumentListener(new Typing());
    JLabel atMost = new JLabel(text("atMostS"));
    atMost.setLabelFor(most);
    bar.add(run);
    bar.add(cancel);
    bar.add(atMost);
    bar.add(most);
    bar.add(add);
    bar.add(remove);
    bar.add(clear);
    bar.add(ways);
    bar.add(ghosts);
    bar.add(from);
    return bar;
  }

  /** Checks how long variants may run while it is typed. */
  private final class Typing implements DocumentListener {
    @Override
    public void insertUpdate(DocumentEvent event) {
      checkMost();
    }

    @Override
    public void removeUpdate(DocumentEvent event) {
      checkMost();
    }

    @Override
    public void changedUpdate(DocumentEvent event) {}
  }

  private OptionalDouble mostS() {
    try {
      double typed = Double.parseDouble(most.getText().strip());
      return typed > 0 && typed <= MAX_S ? OptionalDouble.of(typed) : OptionalDouble.empty();
    } catch (NumberFormatException _) {
      return OptionalDouble.empty();
    }
  }

  private void checkMost() {
    OptionalDouble typed = mostS();
    most.putClientProperty("JComponent.outline", typed.isPresent() ? null : "error");
    String why =
        typed.isPresent() ? "" : text("atMostIsMustBeAbove", most.getText().strip(), MAX_S);
    refused.setText(why);
    refused.setForeground(Palette.error());
    refused.setVisible(!why.isEmpty());
    refresh();
  }

  private void declareActions() {
    var actions = workbench.actions();
    actions.add(
        new Action(
            ID + ".run",
            text("whatIfRunTheVariants"),
            "",
            () -> whyNot().isEmpty(),
            () -> {
              workbench.show(ID);
              run();
            }));
    actions.add(
        new Action(
            ID + ".cancel",
            text("whatIfGiveUpWhatRuns"),
            "",
            presenter::running,
            presenter::cancel));
    actions.add(
        new Action(
            ID + ".add",
            text("whatIfAddAVariant"),
            "",
            presenter::canAdd,
            () -> {
              workbench.show(ID);
              presenter.add();
            }));
    actions.add(
        new Action(
            ID + ".clear",
            text("whatIfClearTheResults"),
            "",
            () -> !presenter.running(),
            presenter::clear));
    actions.add(
        Action.of(WAYS, text("whatIfWaysIn3d"), "", () -> set(WAYS, !on(WAYS)))
            .checked(() -> on(WAYS)));
    actions.add(
        Action.of(GHOSTS, text("whatIfGhostsIn3d"), "", () -> set(GHOSTS, !on(GHOSTS)))
            .checked(() -> on(GHOSTS)));
  }

  private boolean on(String setting) {
    return workbench.settings().get(setting).map(Boolean::parseBoolean).orElse(true);
  }

  private void set(String setting, boolean on) {
    workbench.settings().put(setting, Boolean.toString(on));
    show();
  }

  private String whyNot() {
    return mostS().isEmpty() ? text("howLongAVariantMayRun") : presenter.whyNot();
  }

  private void run() {
    if (table.isEditing() && !table.getCellEditor().stopCellEditing()) {
      return;
    }
    if (whyNot().isEmpty()) {
      ranBy = Optional.of(workbench.session().shown());
      subject = Optional.of(new VariantSubject(program.started(), program.front()));
      presenter.setMost(Duration.ofMillis(Math.round(1000 * mostS().orElseThrow())));
      presenter.run();
    }
  }

  private void show() {
    if (table.isEditing() && table.getEditingRow() >= model.getRowCount()) {
      table.getCellEditor().cancelCellEditing();
    }
    int selected = table.getSelectedRow();
    model.show();
    if (selected >= 0 && table.getSelectedRow() < 0 && model.getRowCount() > 0) {
      int row = Math.min(selected, model.getRowCount() - 1);
      table.setRowSelectionInterval(row, row);
    }
    refresh();
    collect();
  }

  /** Keys of a button that is disabled go to the table, not to the button beside it. */
  private void enable(JButton button, boolean enabled) {
    ButtonKeys.enable(button, enabled, () -> table.requestFocusInWindow());
  }

  private void refresh() {
    String why = whyNot();
    enable(run, why.isEmpty());
    run.setToolTipText(why.isEmpty() ? text("runsEachVariantBesideTheRobot") : why);
    enable(cancel, presenter.running());
    enable(add, presenter.canAdd());
    enable(remove, presenter.canRemove() && table.getSelectedRow() >= 0);
    enable(
        clear,
        !presenter.running()
            && presenter.results().stream().anyMatch(each -> each.finished().isPresent()));
    ways.setSelected(on(WAYS));
    ghosts.setSelected(on(GHOSTS));
    WhatIfPresenter.Start start = presenter.start();
    run.setText(start.words());
    run.getAccessibleContext().setAccessibleName(start.words());
    from.setText(start.refusal().isEmpty() ? ofOther() : Messages.shown(start.refusal()));
    from.setForeground(Palette.quiet());
    from.setVisible(!from.getText().isEmpty());
  }

  /**
   * Whether the variants are those of the program and the arm that are shown, also after that was
   * switched on anew.
   */
  private boolean ofShown() {
    SessionMember shown = workbench.session().shown();
    return ofFront()
        && ranBy.stream()
            .anyMatch(
                each ->
                    each.name().equals(shown.name())
                        && each.options().robotId().equals(shown.options().robotId()));
  }

  /** Whether they are those of the program that people look at. */
  private boolean ofFront() {
    return subject.stream().anyMatch(each -> each.seenWith(program.front()));
  }

  /** Says whose variants they are where another controller of the cell or program is shown. */
  private String ofOther() {
    if (!presenter.running() && !clear.isEnabled()) {
      return "";
    }
    return ranBy
        .map(SessionMember::name)
        .filter(name -> !name.isEmpty() && !name.equals(workbench.session().shown().name()))
        .or(() -> subject.filter(each -> !ofFront()).map(VariantSubject::name))
        .map(name -> text("theResultsAreThoseOf", name))
        .orElse("");
  }

  private void selectionChanged() {
    refresh();
    collect();
  }

  /** What is to be seen, in the colours that the theme has now. */
  private void collect() {
    sights =
        new VariantSights(
            presenter.rows(),
            presenter.results(),
            table.getSelectedRow(),
            row -> Palette.series(row).getRGB() & 0xFFFFFF);
  }

  /**
   * Where the tool went in each variant, and where the arm is in each at the moment that people
   * look at, as far as people want to see that in 3D.
   */
  public ComparedWays ways() {
    if (!ofShown()) {
      return ComparedWays.NONE;
    }
    OptionalLong frame =
        on(GHOSTS)
                && !ofFile.getAsBoolean()
                && ranBy.equals(Optional.of(workbench.session().shown()))
            ? past.get().map(at -> OptionalLong.of(at.frame())).orElse(OptionalLong.empty())
            : OptionalLong.empty();
    return new ComparedWays(on(WAYS) ? sights.ways() : List.of(), sights.ghosts(frame));
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("whatIf");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    refresh();
    collect();
    if (presenter.running()) {
      for (int i = 0; i < model.getRowCount(); i++) {
        model.fireTableCellUpdated(i, VariantTableModel.RESULT);
      }
    }
  }
}
