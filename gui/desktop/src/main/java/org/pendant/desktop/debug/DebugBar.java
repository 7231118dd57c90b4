package org.pendant.desktop.debug;

import java.util.List;
import java.util.function.BooleanSupplier;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.theme.Palette;

/**
 * Debug bar: how a program that is paused continues; it is there only then. It stands in the head
 * of what shows the program.
 */
@SuppressWarnings("serial") // never written to a stream
public final class DebugBar extends JPanel {
  private static final int SIDE = 16;

  private final transient Workbench workbench;
  private final transient DebugPresenter debug;
  private final transient List<Tool> tools;

  /** A button, and when it can be used. */
  private record Tool(JButton button, BooleanSupplier enabled) {}

  /**
   * A bar for what {@code debug} knows.
   *
   * @param name begins the names of its parts
   */
  public DebugBar(String name, Workbench workbench, DebugPresenter debug) {
    super(new MigLayout("insets 0 4 0 4, gap 0, hidemode 3", "", "[center]"));
    this.workbench = workbench;
    this.debug = debug;
    setName(name);
    setOpaque(false);
    getAccessibleContext().setAccessibleName("Debug bar");
    Stepping steps = debug.steps();
    BooleanSupplier any = this::wanted;
    tools =
        List.of(
            tool("Continue", "program.run", Glyph.PLAY.icon(SIDE, Palette.ok()), any),
            tool("Step over", "program.step", drawing("step-over"), steps::canStep),
            tool("Step into", "debug.step-into", drawing("step-into"), steps::canStep),
            tool("Step out", "debug.step-out", drawing("step-out"), steps::canStep),
            tool(
                "Run to the line of the caret",
                "debug.run-to-line",
                drawing("run-to"),
                steps::canStep),
            tool("Stop", "program.stop", Glyph.STOP.icon(SIDE, Palette.error()), any));
    setVisible(false);
  }

  private static Icon drawing(String name) {
    return SvgIcon.of("tool/" + name, SIDE);
  }

  private Tool tool(String title, String action, Icon icon, BooleanSupplier enabled) {
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
    return new Tool(button, enabled);
  }

  private boolean wanted() {
    return debug.held() || debug.steps().canStep();
  }

  /** Shows what can be done now. */
  public void refresh() {
    boolean wanted = wanted();
    tools.forEach(each -> each.button().setEnabled(each.enabled().getAsBoolean()));
    if (wanted != isVisible()) {
      setVisible(wanted);
      revalidate();
      // What it stands in gives it room only when it is laid out as well.
      if (getParent() != null && getParent().getParent() != null) {
        getParent().getParent().revalidate();
      }
    }
  }
}
