package org.pendant.gui.shell.bar;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.Command;
import org.pendant.controller.Pace;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.ProgramControls;
import org.pendant.gui.session.Session;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.look.GlyphIcon;
import org.pendant.gui.workbench.ActionTable;
import org.pendant.gui.workbench.Palette;

/** What is needed at any time: readiness, speed, the pace of time, and the program's buttons. */
@SuppressWarnings("serial") // never written to a stream
public final class Footer extends JPanel {
  /** Layout of a button with and without its word. */
  private static final String WORDED = "cell 3 0, wmin pref, h 36:36:";

  private static final String WORDLESS = "cell 3 0, w 44!, h 36:36:";

  private final transient Session session;
  private final ReadinessBar readiness;
  private final SpeedSlider speed;
  private final JComboBox<PaceChoice> pace = new JComboBox<>();
  private final ActionButton run;
  private final ActionButton frameStep;
  private final List<ActionButton> buttons;
  private final List<String> words = List.of("Run", "Pause", "Step", "Stop");
  private final transient MigLayout layout;
  private boolean narrow;

  /**
   * A footer.
   *
   * @param send has the controller do something, and tells when it is refused
   */
  public Footer(Session session, ActionTable actions, Consumer<Command> send) {
    super(
        new MigLayout(
            "insets 8 12 8 12, gap 8, hidemode 3", "[][grow, fill, :260:260][]push[]", "[center]"));
    layout = (MigLayout) getLayout();
    this.session = session;
    setName("footer");
    readiness = new ReadinessBar(session.state(), send);
    speed =
        new SpeedSlider(percent -> session.submit(new Command.SetSpeedFraction(percent / 100.0)));
    PaceChoice.ALL.forEach(pace::addItem);
    pace.setName("pace");
    pace.setMaximumRowCount(PaceChoice.ALL.size());
    pace.setToolTipText("How fast robot time goes by");
    pace.getAccessibleContext().setAccessibleName("Pace of robot time");
    pace.setSelectedItem(PaceChoice.of(session.pace()));
    pace.addActionListener(
        event -> {
          if (pace.getSelectedItem() instanceof PaceChoice choice) {
            session.setPace(choice.pace());
          }
        });
    frameStep = new ActionButton(actions, "clock.step-frame", "", icon(Glyph.STEP, null));
    run = new ActionButton(actions, "program.run", "Run", icon(Glyph.PLAY, Palette::ok));
    buttons =
        List.of(
            run,
            new ActionButton(actions, "program.pause", "Pause", icon(Glyph.PAUSE, null)),
            new ActionButton(actions, "program.step", "Step", icon(Glyph.STEP, null)),
            new ActionButton(actions, "program.stop", "Stop", icon(Glyph.STOP, Palette::error)));
    add(readiness, "cell 0 0");
    add(speed, "cell 1 0, growx");
    JPanel time = new JPanel(new MigLayout("insets 0, gap 4, hidemode 3", "[][]", "[center]"));
    time.add(pace);
    time.add(frameStep);
    add(time, "cell 2 0");
    buttons.forEach(each -> add(each, WORDED));
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  /** Leaves out what does not fit: first words, the buttons never. */
  private void fit() {
    narrow = false;
    showWords();
    speed.setVisible(true);
    pace.setVisible(true);
    if (tooWide()) {
      narrow = true;
      showWords();
    }
    if (tooWide()) {
      speed.setVisible(false);
    }
    if (tooWide()) {
      pace.setVisible(false);
    }
    revalidate();
  }

  @Override
  public void updateUI() {
    super.updateUI();
    // Sizes are known when all parts have their new look.
    EventQueue.invokeLater(
        () -> {
          if (buttons != null) {
            fit();
          }
        });
  }

  private boolean tooWide() {
    layout.invalidateLayout(this);
    return layout.minimumLayoutSize(this).width > getWidth();
  }

  private void showWords() {
    for (int i = 0; i < words.size(); i++) {
      buttons.get(i).setText(narrow ? "" : words.get(i));
      layout.setComponentConstraints(buttons.get(i), narrow ? WORDLESS : WORDED);
    }
  }

  private static GlyphIcon icon(Glyph glyph, Supplier<Color> color) {
    return color == null ? GlyphIcon.of(glyph, 16) : GlyphIcon.of(glyph, 16, color);
  }

  /** Shows a snapshot. */
  public void refresh(ControllerState state) {
    readiness.refresh(state);
    speed.follow(state.arm().speedFraction());
    PaceChoice chosen = PaceChoice.of(session.pace());
    if (!chosen.equals(pace.getSelectedItem())) {
      pace.setSelectedItem(chosen);
    }
    frameStep.setVisible(chosen.pace() instanceof Pace.Paused);
    frameStep.refresh();
    String word = ProgramControls.of(state).canResume() ? "Resume" : "Run";
    if (!narrow && !word.equals(run.getText())) {
      run.setText(word);
    }
    buttons.forEach(ActionButton::refresh);
    if (!narrow && tooWide()) {
      fit();
    }
  }

  @Override
  protected void paintComponent(Graphics g) {
    super.paintComponent(g);
    g.setColor(Palette.line());
    g.drawLine(0, 0, getWidth(), 0);
  }
}
