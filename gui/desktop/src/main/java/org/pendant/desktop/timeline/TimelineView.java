package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.EventQueue;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.LongConsumer;
import java.util.function.Supplier;
import javax.swing.AbstractButton;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ScrollPaneConstants;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Scene;
import org.pendant.desktop.session.Branching;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.unit.FormMemory;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.layout.Squeeze;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingExport;
import org.pendant.recording.RecordingFile;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.replay.RerunRefused;

/** Timeline view: the panel with what the robot did over time. */
public final class TimelineView implements View {
  /** Its name in settings and commands. */
  public static final String ID = "timeline";

  private static final String OPEN = text("openRecording");
  private static final String SAVE = text("saveAsATest");
  private static final String BRANCH = text("branchFromHere");
  private static final int THOUSAND = 1000;

  private final Workbench workbench;
  private final LookBack lookBack;
  private static final int LOOK_MS = 200;

  private final BranchControl branch;
  private final Timer lookSoon;
  private final TimelineCanvas canvas;
  private final TrackWatch watch;
  private final CardLayout cards = new CardLayout();
  private final JPanel head = new JPanel(cards);
  private final JPanel content = new JPanel(new BorderLayout());
  private final JButton live = button("live", text("live"), text("backToWhatTheRobotDoes"));
  private final JButton save = button("save-test", SAVE, "");
  private final JButton branchButton = button("branch", BRANCH, "");
  private final JLabel question = new JLabel();
  private Supplier<String> whyNotSave = () -> "";
  private final JButton yes =
      button("branch-yes", text("branchNow"), text("continuesFromThatMoment"));
  private final JProgressBar progress = new JProgressBar(0, THOUSAND);

  /**
   * The timeline of the session.
   *
   * @param lookBack what the other views show
   * @param chooseFile asks for a recording to open
   */
  public TimelineView(Workbench workbench, LookBack lookBack, Runnable chooseFile) {
    this.workbench = workbench;
    this.lookBack = lookBack;
    branch =
        new BranchControl(
            lookBack,
            new SessionBranches(workbench.session()),
            EventQueue::invokeLater,
            workbench::notify,
            this::showBranch);
    canvas = new TimelineCanvas(lookBack, () -> FormMemory.read(workbench.settings()));
    watch = new TrackWatch(canvas::show);
    content.setName("timeline-view");
    content.getAccessibleContext().setAccessibleName(title());
    head.add(bar(chooseFile), "bar");
    head.add(asking(), "asking");
    head.add(running(), "running");
    content.add(head, BorderLayout.NORTH);
    JScrollPane rows = new JScrollPane(canvas);
    rows.setBorder(BorderFactory.createEmptyBorder());
    rows.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
    content.add(rows, BorderLayout.CENTER);
    content.setBorder(BorderFactory.createEmptyBorder());
    declareActions(chooseFile);
    lookBack.addListener(this::show);
    lookSoon = Faults.timer(LOOK_MS, this::look);
    lookSoon.setRepeats(false);
    lookBack.addListener(lookSoon::restart);
    show();
  }

  /** People have come to rest at a moment: a branch from there may be wanted. */
  private void look() {
    Optional<ControllerState> start = lookBack.ofFile() ? Optional.empty() : lookBack.branchStart();
    workbench
        .session()
        .look(start.map(state -> OptionalLong.of(state.frame())).orElse(OptionalLong.empty()));
  }

  /** Shows the worst moments of runs as pins, see {@link Pins#from}. */
  public void setPins(Supplier<RunProfile> live, Function<RunProfile, List<Pin>> words) {
    canvas.pins().from(live, words);
  }

  /** Calls lines of programs so in what is told of moments. */
  public void nameLinesBy(MomentPlaces names) {
    canvas.nameLinesBy(names);
  }

  /**
   * Marks what clients of the ports did.
   *
   * @param marks in the order of time
   * @param wanted shows the message with a number
   */
  public void markClients(Supplier<List<ClientMark>> marks, LongConsumer wanted) {
    canvas.markClients(marks, wanted);
  }

  /**
   * Has a button write a test from the last run.
   *
   * @param whyNot why that cannot be done now; empty if it can
   */
  public void saveTestBy(Supplier<String> whyNot, Runnable write) {
    whyNotSave = whyNot;
    save.addActionListener(event -> write.run());
    showSave();
  }

  private void showSave() {
    String why = whyNotSave.get();
    save.setEnabled(why.isEmpty());
    save.setToolTipText(why.isEmpty() ? text("writesATestThatRepeatsThe") : why);
  }

  private record SessionBranches(RobotSession session) implements BranchControl.Branches {
    @Override
    public Optional<String> refusal(long frame) {
      return session.branchRefusal(frame);
    }

    @Override
    public Branching begin(ControllerState recorded) throws RerunRefused {
      return session.branch(recorded);
    }
  }

  private static JButton button(String name, String text, String tip) {
    JButton button = new JButton(text);
    button.setName("timeline-" + name);
    button.setToolTipText(tip.isEmpty() ? text : tip);
    button.putClientProperty("FlatLaf.style", "margin: 2,8,2,8; minimumWidth: 0");
    button.getAccessibleContext().setAccessibleName(text);
    return button;
  }

  private static JButton button(String name, String text, String tip, Runnable run) {
    JButton button = button(name, text, tip);
    button.addActionListener(event -> run.run());
    return button;
  }

  /** One row always: words become shorter, then what is in the menu, too, is left out. */
  private JPanel bar(Runnable chooseFile) {
    JPanel bar = new JPanel(new MigLayout("insets 4 6 4 6, gap 6, hidemode 3"));
    live.addActionListener(event -> lookBack.live());
    branchButton.addActionListener(event -> branch.ask());
    JButton all = button("all", text("showAll"), text("showsAllThatIsKept"), lookBack::showAll);
    JButton export =
        button("export", text("exportRange"), text("savesTheStretchThatIsShown"), this::export);
    JButton open = button("open", OPEN, text("showsARecordingOfAFile"), chooseFile);
    bar.add(live);
    bar.add(
        button(
            "mark-before",
            text("markBefore"),
            text("toTheLastMarkBeforeStart"),
            () -> canvas.toMark(false)));
    bar.add(
        button(
            "mark-after",
            text("markAfter"),
            text("toTheNextMarkStartEnd"),
            () -> canvas.toMark(true)));
    bar.add(all);
    bar.add(branchButton);
    bar.add(export);
    bar.add(save);
    bar.add(open);
    Squeeze squeeze =
        new Squeeze(
            bar,
            List.of(
                whole -> open.setText(whole ? OPEN : text("openShort")),
                whole -> branchButton.setText(whole ? BRANCH : text("branchShort")),
                whole -> save.setText(whole ? SAVE : text("testShort")),
                open::setVisible,
                export::setVisible,
                save::setVisible,
                all::setVisible));
    // its words change
    live.addPropertyChangeListener(AbstractButton.TEXT_CHANGED_PROPERTY, e -> squeeze.fitLater());
    squeeze.fitLater();
    return bar;
  }

  private JPanel asking() {
    JPanel row = new JPanel(new MigLayout("insets 6, gap 8", "[grow, fill, 0::][][]"));
    question.setName("timeline-question");
    row.add(question, "wmin 0");
    yes.addActionListener(event -> branch.confirm());
    row.add(yes);
    row.add(button("branch-no", text("cancel"), text("leavesEverythingAsItIs"), branch::cancel));
    row.registerKeyboardAction(
        event -> branch.cancel(),
        KeyStroke.getKeyStroke("ESCAPE"),
        JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT);
    return row;
  }

  private JPanel running() {
    JPanel row = new JPanel(new MigLayout("insets 6, gap 8", "[][grow, fill, 0::][]"));
    progress.setName("timeline-progress");
    progress.getAccessibleContext().setAccessibleName(text("progressOfTheBranch"));
    row.add(new JLabel(text("theRunIsRepeatedUpTo")));
    row.add(progress);
    row.add(
        button("branch-cancel", text("cancel"), text("leavesEverythingAsItIs"), branch::cancel));
    return row;
  }

  private void declareActions(Runnable chooseFile) {
    var actions = workbench.actions();
    actions.add(
        new Action(ID + ".live", text("timelineBackToNow"), "", lookBack::back, lookBack::live));
    actions.add(
        Action.of(
            ID + ".mark-before", text("timelineToTheMarkBefore"), "", () -> canvas.toMark(false)));
    actions.add(
        Action.of(
            ID + ".mark-after", text("timelineToTheNextMark"), "", () -> canvas.toMark(true)));
    actions.add(
        Action.of(
            ID + ".worst-before",
            text("timelineToTheWorstMomentBefore"),
            "",
            () -> canvas.toPin(false)));
    actions.add(
        Action.of(
            ID + ".worst-after",
            text("timelineToTheNextWorstMoment"),
            "",
            () -> canvas.toPin(true)));
    actions.add(Action.of(ID + ".export", text("timelineExportWhatItShows"), "", this::export));
    actions.add(
        new Action(
            ID + ".branch",
            text("timelineBranchFromHere"),
            "",
            () -> branch.whyNot().isEmpty(),
            () -> {
              workbench.show(ID);
              branch.ask();
            }));
    actions.add(Action.of("file.open-recording", text("openRecording"), "", chooseFile));
  }

  /**
   * Opens a recording; it is read elsewhere.
   *
   * @param trouble hears why it cannot be opened, or that it is not whole
   */
  public void open(Path file, Consumer<String> trouble) {
    Thread.ofVirtual()
        .name("recording")
        .start(
            () -> {
              try {
                RecordingFile.Opened opened = RecordingFile.open(file);
                Recording recording = opened.recording();
                List<LogEntry> log = recording.log(recording.firstS(), recording.lastS());
                // its first moment is shown at once, from memory
                recording.atFrame(recording.firstFrame());
                EventQueue.invokeLater(
                    () -> {
                      opened.warning().ifPresent(trouble);
                      canvas.pins().setFile(RunProfile.NONE);
                      lookBack.open(recording, file, log);
                      workbench.show(ID);
                    });
                makeIndex(recording);
                SafetyChecksum held = recording.atFrame(recording.lastFrame()).safety().checksum();
                RunProfile profile =
                    LineProfiler.of(recording, workbench.session().safety(held, recording.arm()));
                EventQueue.invokeLater(() -> canvas.pins().setFile(profile));
              } catch (UncheckedIOException e) {
                String why = FileTrouble.reason(e.getCause());
                EventQueue.invokeLater(() -> trouble.accept(text("fileNotOpened", file, why)));
              } catch (IOException e) {
                String why = FileTrouble.reason(e);
                EventQueue.invokeLater(() -> trouble.accept(text("fileNotOpened", file, why)));
              }
            });
  }

  private static void makeIndex(Recording recording) {
    try {
      recording.makeIndex();
    } catch (UncheckedIOException e) {
      // The file has gone. A user who looks at a moment of it is told.
      return;
    }
  }

  /** Whether a file is a recording, by its name. */
  public static boolean isRecording(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".rec");
  }

  private void export() {
    Recording recording = lookBack.recording();
    List<Path> inUse = new ArrayList<>(workbench.openFiles());
    lookBack.path().ifPresent(inUse::add);
    TimeRange range = lookBack.range();
    double fromS = Math.max(range.fromS(), recording.firstS());
    double toS = Math.min(range.toS(), recording.lastS());
    SaveDialog.open(
        content,
        new SaveRequest(
            text("exportTo", LookBack.text(fromS), LookBack.text(toS)),
            workbench.exportFile("run.rec"),
            List.of("rec", "csv"),
            inUse),
        file -> {
          if (isRecording(file)) {
            RecordingExport.toRec(recording, fromS, toS, file);
          } else {
            RecordingExport.toCsv(recording, fromS, toS, file);
          }
        },
        workbench::notify);
  }

  private void show() {
    live.setEnabled(lookBack.back());
    live.setText(lookBack.ofFile() ? text("backToTheRobot") : text("live"));
    live.getAccessibleContext().setAccessibleName(live.getText());
    String why = branch.whyNot();
    branchButton.setEnabled(why.isEmpty());
    branchButton.setToolTipText(why.isEmpty() ? text("putsTheRobotBackToThis") : why);
    canvas.repaint();
  }

  private void showBranch() {
    question.setText(branch.question().orElse(""));
    question.setToolTipText(branch.question().orElse(null));
    question.setToolTipText(question.getText());
    question.setForeground(Palette.warning());
    cards.show(
        head,
        branch.question().isPresent()
            ? "asking"
            : branch.progress().isPresent() ? "running" : "bar");
    show();
    if (branch.question().isPresent()) {
      yes.requestFocusInWindow();
    } else if (content.isShowing()) {
      canvas.requestFocusInWindow();
    }
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("timeline");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    showSave();
    branch.progress().ifPresent(share -> progress.setValue((int) (THOUSAND * share)));
    // a file does not say whether the programs in it had one
    boolean startRamp = !lookBack.ofFile() && workbench.session().options().startRamp();
    boolean cell = lookBack.ofFile() || somethingAround(workbench.session());
    watch.look(lookBack.recording(), lookBack.range(), canvas.buckets(), startRamp, cell);
    canvas.repaint();
  }

  /** Whether links can get into more than one another: objects, or links of another arm. */
  static boolean somethingAround(RobotSession session) {
    return !session.options().scene().equals(Scene.EMPTY)
        || session.members().stream().filter(each -> !each.armless()).count() > 1;
  }
}
