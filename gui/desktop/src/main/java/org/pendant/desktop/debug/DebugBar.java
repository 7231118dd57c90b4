package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.Dimension;
import java.util.List;
import java.util.function.BooleanSupplier;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.timeline.PastSteps;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.theme.Palette;
import org.pendant.script.vm.ProgramState;

/**
 * Debug bar: how a program that is paused continues, and how people go back and on through what it
 * did. It is there only then, while they look at the past, and as long as keys go to it while the
 * program runs: what is typed must not fall into the text. Where it has room of its own it stays
 * when a program has ended, with what leads back. It stands in the head of what shows the program.
 */
@SuppressWarnings("serial") // never written to a stream
public final class DebugBar extends JPanel {
  private static final int SIDE = 16;
  private static final int MARGIN = 4;

  private final transient Workbench workbench;
  private final transient DebugPresenter debug;
  private final transient PastSteps past;
  private final transient List<Tool> tools;
  private boolean roomKept;

  /** So wide it is at least, px. */
  private int roomPx;

  /** When a button is there. */
  private enum When {
    NOW,
    PAST,
    ALWAYS
  }

  /** A button, and when it can be used. */
  private record Tool(JButton button, BooleanSupplier enabled, When when) {
    boolean focused() {
      return button.isFocusOwner();
    }
  }

  /**
   * A bar for what {@code debug} knows.
   *
   * @param name begins the names of its parts
   * @param past how people go back and on through the past
   */
  public DebugBar(String name, Workbench workbench, DebugPresenter debug, PastSteps past) {
    super(
        new MigLayout(
            "insets 0 " + MARGIN + " 0 " + MARGIN + ", gap 0, hidemode 3", "", "[center]"));
    this.workbench = workbench;
    this.debug = debug;
    this.past = past;
    setName(name);
    setOpaque(false);
    getAccessibleContext().setAccessibleName(text("debugBar"));
    BooleanSupplier any = this::wanted;
    Icon run = Glyph.PLAY.icon(SIDE, Palette.ok());
    Icon stop = Glyph.STOP.icon(SIDE, Palette.error());
    tools =
        List.of(
            back(text("reverseContinue"), "past.reverse-continue", "reverse-continue"),
            back(text("stepBack"), "past.step-back", "step-back"),
            on(text("nextStatementOfTheRecording"), "past.step-on", "step-over"),
            on(text("nextBreakpointOfTheRecording"), "past.continue", "continue-on"),
            on(text("backToNowEsc"), "timeline.live", "to-now"),
            tool(text("continueLabel"), "program.run", run, any, When.NOW),
            step(text("stepOver"), "program.step", "step-over"),
            step(text("stepInto"), "debug.step-into", "step-into"),
            step(text("stepOut"), "debug.step-out", "step-out"),
            step(text("runToTheLineOfThe"), "debug.run-to-line", "run-to"),
            tool(text("stop"), "program.stop", stop, any, When.NOW));
    setVisible(false);
  }

  private Tool back(String title, String action, String drawing) {
    BooleanSupplier enabled = () -> past.whyNoBack().isEmpty();
    return tool(title, action, drawing(drawing), enabled, When.ALWAYS);
  }

  private Tool on(String title, String action, String drawing) {
    return tool(title, action, drawing(drawing), past::back, When.PAST);
  }

  private Tool step(String title, String action, String drawing) {
    return tool(title, action, drawing(drawing), debug.steps()::canStep, When.NOW);
  }

  private static Icon drawing(String name) {
    return SvgIcon.of("tool/" + name, SIDE);
  }

  private Tool tool(String title, String action, Icon icon, BooleanSupplier enabled, When when) {
    JButton button =
        new JButton(icon) {
          @Override
          public String getToolTipText() {
            String keys = KeyText.shown(workbench.actions().keysOf(action));
            return keys.isEmpty() ? title : title + " (" + keys + ")";
          }
        };
    button.setName(getName() + "-" + action.substring(action.indexOf('.') + 1));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setToolTipText(title);
    button.getAccessibleContext().setAccessibleName(title);
    button.addActionListener(event -> workbench.actions().run(action));
    add(button);
    return new Tool(button, enabled, when);
  }

  /**
   * Has it be as wide always as it ever becomes, so that nothing beside it moves when buttons come
   * and go, and have what leads back stay when a program has ended.
   */
  public void keepRoom() {
    roomKept = true;
    tools.forEach(each -> each.button().setVisible(false));
    setVisible(true);
  }

  /**
   * While people look back it is as wide as it was when they began to: it stands at the end of a
   * row, and its first buttons lead back.
   */
  @Override
  public Dimension getPreferredSize() {
    Dimension size = super.getPreferredSize();
    return new Dimension(Math.max(size.width, roomKept ? mostPx() : roomPx), size.height);
  }

  /** With all the buttons that are ever there at one time. */
  private int mostPx() {
    int besidesPx = getInsets().left + getInsets().right + 2 * MARGIN;
    int timelyPx = Math.max(widthPx(When.NOW), widthPx(When.PAST));
    return besidesPx + widthPx(When.ALWAYS) + timelyPx;
  }

  private int widthPx(When when) {
    return tools.stream()
        .filter(each -> each.when() == when)
        .mapToInt(each -> each.button().getPreferredSize().width)
        .sum();
  }

  private boolean wanted() {
    return past.back() || debug.held() || debug.steps().canStep();
  }

  /** A button that has nothing to do any more gives its focus to the first that has. */
  private void keepFocus(When gone) {
    if (tools.stream().anyMatch(each -> each.when() == gone && each.focused())) {
      tools.stream()
          .filter(each -> each.when() != gone && each.enabled().getAsBoolean())
          .findFirst()
          .ifPresent(each -> each.button().requestFocusInWindow());
    }
  }

  /** Shows what can be done now. */
  public void refresh() {
    boolean runs = workbench.session().state().program().state() != ProgramState.STOPPED;
    roomPx = past.back() && isVisible() ? getPreferredSize().width : 0;
    boolean over = roomKept && !runs && !wanted() && workbench.session().runTime().known();
    boolean wanted = wanted() || over || (runs && tools.stream().anyMatch(Tool::focused));
    When other = past.back() ? When.NOW : When.PAST;
    for (Tool each : tools) {
      // A button that goes or becomes disabled hands its focus on, and keys would write in the
      // text.
      boolean focused = each.focused();
      boolean there = wanted && each.when() != other && !(over && each.when() == When.NOW);
      each.button().setVisible(there || focused);
      each.button().setEnabled(each.enabled().getAsBoolean() || focused);
    }
    keepFocus(over ? When.NOW : other);
    boolean visible = wanted || roomKept;
    if (visible != isVisible()) {
      setVisible(visible);
      revalidate();
      // What it stands in gives it room only when it is laid out as well.
      if (getParent() != null && getParent().getParent() != null) {
        getParent().getParent().revalidate();
      }
    }
  }
}
