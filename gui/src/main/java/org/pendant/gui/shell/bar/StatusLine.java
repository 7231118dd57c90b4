package org.pendant.gui.shell.bar;

import java.util.Locale;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.gui.workbench.Palette;

/** The last thing that was told, and how punctual the frames are. */
@SuppressWarnings("serial") // never written to a stream
public final class StatusLine extends JPanel {
  private final JLabel told = new JLabel(" ");
  private final JLabel punctual = new JLabel(" ");
  private long frames;
  private long late;
  private int calls;

  /** Nothing was told yet. */
  public StatusLine() {
    super(new MigLayout("insets 2 12 2 12, gap 16", "[grow, 0::, fill][right]", "[center]"));
    told.setName("status-text");
    told.getAccessibleContext().setAccessibleName("Last notice");
    punctual.setName("status-frames");
    punctual.getAccessibleContext().setAccessibleName("Lateness of frames");
    add(told, "growx, wmin 0");
    add(punctual);
  }

  /** Shows a sentence, until the next one. */
  public void tell(String text) {
    told.setText(text.isEmpty() ? " " : text);
    told.setToolTipText(text);
  }

  /**
   * Shows how punctual the frames are; called 30 times a second.
   *
   * @param held whether a debugger holds the frame
   */
  public void refresh(Lateness lateness, boolean held) {
    calls++;
    if (calls % 60 != 1) {
      return;
    }
    if (held) {
      // Frames are not due then.
      punctual.setText(" ");
      return;
    }
    punctual.setForeground(Palette.quiet());
    punctual.setText(text(lateness, frames, late));
    punctual.setToolTipText(
        String.format(
            Locale.ROOT,
            "Frames of robot time that began more than 1 ms late in the last two seconds; the"
                + " latest so far was %.1f ms late",
            lateness.worstNs() / 1e6));
    frames = lateness.frames();
    late = lateness.lateFrames();
  }

  /** How punctual the frames were since there were {@code frames}, {@code late} of them late. */
  static String text(Lateness lateness, long frames, long late) {
    long count = lateness.frames() - frames;
    if (count <= 0) {
      return " ";
    }
    return String.format(
        Locale.ROOT, "500 Hz, %.1f %% late", 100.0 * (lateness.lateFrames() - late) / count);
  }
}
