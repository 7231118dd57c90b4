package org.pendant.desktop.waveform;

import static org.pendant.desktop.waveform.WaveformTexts.text;

import java.awt.BorderLayout;
import java.awt.CardLayout;
import java.awt.EventQueue;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.UnaryOperator;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.SwingConstants;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.WaveformText;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.kit.form.Remark;
import org.pendant.kit.theme.HtmlLabel;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.Recording;
import org.pendant.script.vm.ProgramState;

/**
 * Waveform view: the panel in which people draw what happens at the inputs. Each controller of a
 * cell has waveforms of its own; the panel has those of the one that is shown.
 */
public final class WaveformView implements View, SwitchListener {
  /** Its name in settings and commands. */
  public static final String ID = "waveforms";

  private static final String TABLE = "waveforms.table";
  private static final String PLAY = "waveforms.play";
  private static final String ENDING = "csv";

  /** A longer table is not kept over a restart; it has a file. */
  private static final int MAX_KEPT = 100_000;

  private static final long MAX_FILE_BYTES = 16 << 20;

  private static final String NOTE = text("nothingHappensAtTheInputsBy");

  private final Workbench workbench;
  private final WaveformDraft draft;
  private final WaveformCanvas canvas;
  private final WaveformBar bar;
  private final WaveformPlayer player;
  private final WaveformNames names;
  private final WaveformTimes times;
  private final Remark remark = new Remark("waveform-remark", Palette::error);
  private final CardLayout cards = new CardLayout();
  private final JPanel middle = new JPanel(cards);
  private final JPanel content = new JPanel(new BorderLayout());
  private Optional<Path> file = Optional.empty();

  /** The name of the controller whose waveforms are there. */
  private String showing;

  /** What the others have drawn, by their names. */
  private final Map<String, Drawn> drawnOf = new HashMap<>();

  /** What one controller has drawn. */
  private record Drawn(
      WaveformDraft.Steps steps, boolean playing, WaveformCapture capture, Optional<Path> file) {
    InputWaveforms played() {
      return playing ? steps.sheet().waveforms() : InputWaveforms.NONE;
    }
  }

  /**
   * With what was drawn last.
   *
   * @param nameOf the name that people gave a signal such as {@code digital_in[0]}; empty for none
   * @param chooseFile asks for a table to open
   */
  public WaveformView(Workbench workbench, UnaryOperator<String> nameOf, Runnable chooseFile) {
    this.workbench = workbench;
    showing = workbench.session().shown().name();
    Drawn kept = kept(showing);
    draft = new WaveformDraft(kept.steps());
    WaveformPainter painter = new WaveformPainter(nameOf);
    canvas = new WaveformCanvas(draft, painter, this::number);
    bar = new WaveformBar(draft, canvas, remark::say);
    names = new WaveformNames(canvas, painter);
    times = new WaveformTimes(canvas);
    player = new WaveformPlayer(workbench.session());
    workbench.session().addSwitchListener(player);
    workbench.session().addSwitchListener(this);
    addButtons(chooseFile);
    content.setName("waveform-view");
    content.getAccessibleContext().setAccessibleName(title());
    JPanel head = new JPanel(new BorderLayout());
    head.add(bar, BorderLayout.CENTER);
    head.add(remark, BorderLayout.SOUTH);
    content.add(head, BorderLayout.NORTH);
    middle.add(sheet(), "sheet");
    JLabel note = new HtmlLabel(SwingConstants.CENTER);
    note.setText("<html><center>" + NOTE);
    note.setName("waveform-note");
    note.setBorder(BorderFactory.createEmptyBorder(8, 24, 8, 24));
    note.setEnabled(false);
    middle.add(note, "note");
    content.add(middle, BorderLayout.CENTER);
    bar.setPlaying(kept.playing());
    bar.onPlaying(this::changed);
    canvas.onSelection(this::show);
    draft.addListener(this::changed);
    declareActions(chooseFile);
    changed();
    follow();
  }

  @Override
  public void switchingOff() {}

  @Override
  public void switchedOn() {
    EventQueue.invokeLater(this::follow);
  }

  @Override
  public void shown() {
    switchedOn();
  }

  /** Has the waveforms of the controller that is shown, and the others play theirs. */
  private void follow() {
    for (SessionMember each : workbench.session().members()) {
      if (!each.name().equals(showing)) {
        Drawn own = drawnOf.computeIfAbsent(each.name(), this::kept);
        player.play(each.name(), own.played());
      }
    }
    String now = workbench.session().shown().name();
    if (now.equals(showing)) {
      return;
    }
    drawnOf.put(showing, new Drawn(draft.steps(), bar.playing(), canvas.capture(), file));
    Drawn next = drawnOf.remove(now);
    showing = now;
    file = next.file();
    bar.setPlaying(next.playing());
    canvas.show(next.capture());
    draft.open(next.steps());
  }

  private String number() {
    return bar.number();
  }

  private JScrollPane sheet() {
    JScrollPane sheet = new JScrollPane(canvas);
    sheet.setBorder(BorderFactory.createEmptyBorder());
    sheet.setRowHeaderView(names);
    sheet.setColumnHeaderView(times);
    sheet.getHorizontalScrollBar().setUnitIncrement(40);
    sheet.getVerticalScrollBar().setUnitIncrement(20);
    return sheet;
  }

  private void addButtons(Runnable chooseFile) {
    JButton capture =
        WaveformBar.button(
            "capture", text("lastRun"), text("theDigitalInputsAsTheyChanged"), this::capture);
    JButton open =
        WaveformBar.button("open", text("open"), text("opensATableOfWaveforms"), chooseFile);
    JButton save =
        WaveformBar.button("save", text("save"), text("savesATableAlsoForPendant"), this::save);
    bar.add(capture);
    bar.add(open);
    bar.add(save);
    bar.addValue();
    bar.keepToOneRow(List.of(open, save, capture));
  }

  private void declareActions(Runnable chooseFile) {
    var actions = workbench.actions();
    actions.add(
        Action.of(
                ID + ".play",
                text("waveformsPlayWithPrograms"),
                "",
                () -> {
                  bar.setPlaying(!bar.playing());
                  changed();
                })
            .checked(bar::playing));
    actions.add(
        Action.of(
            ID + ".capture",
            text("waveformsTakeTheInputsOfThe"),
            "",
            () -> {
              workbench.show(ID);
              capture();
            }));
    actions.add(Action.of(ID + ".open", text("waveformsOpenATable"), "", chooseFile));
    actions.add(Action.of(ID + ".save", text("waveformsSaveTheTable"), "", this::save));
  }

  /** What a controller had when the window was closed. */
  private Drawn kept(String controller) {
    return new Drawn(
        new WaveformDraft.Steps(keptSheet(controller)),
        workbench.settings().get(key(PLAY, controller)).map(Boolean::parseBoolean).orElse(false),
        WaveformCapture.NONE,
        Optional.empty());
  }

  private WaveSheet keptSheet(String controller) {
    String table = workbench.settings().get(key(TABLE, controller)).orElse("").replace(';', '\n');
    try {
      return table.isEmpty()
          ? WaveSheet.EMPTY
          : WaveSheet.of(WaveformText.parse("settings", table));
    } catch (IllegalArgumentException e) {
      // Settings are written by people, too.
      return WaveSheet.EMPTY;
    }
  }

  private static String key(String setting, String controller) {
    return controller.isEmpty() ? setting : setting + "." + controller;
  }

  /** Has the controller play what is drawn, and keeps it over restarts. */
  private void changed() {
    InputWaveforms waveforms = draft.sheet().waveforms();
    player.play(showing, bar.playing() ? waveforms : InputWaveforms.NONE);
    String table = WaveformText.format(waveforms).replace('\n', ';');
    workbench.settings().put(key(TABLE, showing), table.length() > MAX_KEPT ? "" : table);
    workbench.settings().put(key(PLAY, showing), Boolean.toString(bar.playing()));
    show();
  }

  private void show() {
    boolean empty = draft.sheet().rows().isEmpty() && canvas.capture().outputs().isEmpty();
    cards.show(middle, empty ? "note" : "sheet");
    bar.refresh();
    names.revalidate();
    names.repaint();
    times.revalidate();
    times.repaint();
  }

  private void capture() {
    SessionMember of = workbench.session().shown();
    Recording recording = of.recording();
    Thread.ofVirtual()
        .name("waveforms")
        .start(
            () -> {
              Optional<WaveformCapture> run = WaveformCapture.of(recording);
              EventQueue.invokeLater(() -> captured(of, run));
            });
  }

  private void captured(SessionMember of, Optional<WaveformCapture> run) {
    if (!of.name().equals(showing)) {
      return; // people look at another controller meanwhile
    }
    if (run.isEmpty()) {
      workbench.notify(text("noProgramHasRunYetThere"));
      return;
    }
    canvas.show(run.get());
    if (run.get().sheet().rows().isEmpty()) {
      workbench.notify(text("noDigitalInputChangedInThe"));
    } else {
      draft.set(run.get().sheet());
    }
    show();
  }

  /** Opens a table; it is read elsewhere. */
  public void open(Path path) {
    Thread.ofVirtual().name("waveforms").start(() -> read(path));
  }

  private void read(Path path) {
    try {
      if (Files.size(path) > MAX_FILE_BYTES) {
        tell(text("notOpenedIsLargerThanAny", path));
        return;
      }
      InputWaveforms waveforms =
          WaveformText.parse(
              String.valueOf(path.getFileName()), Files.readString(path, StandardCharsets.UTF_8));
      EventQueue.invokeLater(
          () -> {
            draft.set(WaveSheet.of(waveforms));
            file = Optional.of(path);
            workbench.show(ID);
            workbench.notify(text("opened", path));
          });
    } catch (IOException e) {
      tell(text("notOpened", path, FileTrouble.reason(e)));
    } catch (IllegalArgumentException e) {
      tell(text("notOpenedBecause", e.getMessage()));
    }
  }

  private void tell(String text) {
    EventQueue.invokeLater(() -> workbench.notify(text));
  }

  /** Whether a file is a table of waveforms, by its name. */
  public static boolean isWaveforms(Path path) {
    return path.toString().toLowerCase(Locale.ROOT).endsWith("." + ENDING);
  }

  private void save() {
    byte[] table = WaveformText.format(draft.sheet().waveforms()).getBytes(StandardCharsets.UTF_8);
    SaveDialog.open(
        content,
        new SaveRequest(
            text("saveWaveforms"),
            file.orElse(workbench.exportFile("inputs.csv")),
            List.of(ENDING),
            workbench.openFiles()),
        path -> {
          AtomicFile.write(path, table);
          EventQueue.invokeLater(() -> file = Optional.of(path));
        },
        workbench::notify);
  }

  @Override
  public String id() {
    return ID;
  }

  @Override
  public String title() {
    return text("waveforms");
  }

  @Override
  public JComponent component() {
    return content;
  }

  @Override
  public void refresh(ControllerState state) {
    RunTime run = workbench.session().runTime();
    boolean runs = run.known() && state.program().state() != ProgramState.STOPPED;
    canvas.showPlace(runs ? place(state.timeS() - run.beganS()) : OptionalDouble.empty());
  }

  private OptionalDouble place(double sinceStartS) {
    OptionalDouble periodS = draft.sheet().periodS();
    return OptionalDouble.of(
        periodS.isPresent() && bar.playing() ? sinceStartS % periodS.getAsDouble() : sinceStartS);
  }
}
