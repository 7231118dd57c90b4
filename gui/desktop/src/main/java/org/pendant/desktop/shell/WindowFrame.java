package org.pendant.desktop.shell;

import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.Image;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.layout.WindowBounds;
import org.pendant.kit.settings.Settings;

/**
 * Window frame: the frame around everything: its place on the screen, remembered, and its picture.
 */
final class WindowFrame {
  private static final String BOUNDS = "window.bounds";
  private static final String MAXIMIZED = "window.maximized";

  /** So long its making waits for a first picture that nobody may ever see. */
  private static final int UNSEEN_MS = 200;

  private static final Color GROUND = new Color(0x2F5D8C);

  private final Settings settings;
  private final JFrame frame = new PaintedFrame();
  private final List<Runnable> waiting = new ArrayList<>();
  private Optional<Runnable> close = Optional.empty();
  private boolean closeWanted;

  /** The frame where it was last time, not visible yet; it stays open until it is ended. */
  WindowFrame(Settings settings) {
    this.settings = settings;
    frame.setName("pendant");
    frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
    frame.addWindowListener(
        new WindowAdapter() {
          @Override
          public void windowClosing(WindowEvent event) {
            wantClosed();
          }
        });
    frame.setBounds(remembered());
    frame.setMinimumSize(new Dimension(720, 480));
    if (settings.get(MAXIMIZED).map(Boolean::parseBoolean).orElse(false)) {
      frame.setExtendedState(Frame.MAXIMIZED_BOTH);
    }
  }

  JFrame frame() {
    return frame;
  }

  /** Has {@code close} run when people want it closed, also if they wanted it already. */
  void askedToClose(Runnable close) {
    this.close = Optional.of(close);
    if (closeWanted) {
      EventQueue.invokeLater(close);
    }
  }

  private void wantClosed() {
    closeWanted = true;
    close.ifPresent(Runnable::run);
  }

  /**
   * Shows where its parts will be, before they are there.
   *
   * @param next makes them; runs when people see that, and soon if nothing is painted, as in a
   *     window that begins minimised
   */
  void showOutline(Runnable next) {
    Timer unseen = Faults.timer(UNSEEN_MS, this::painted);
    unseen.setRepeats(false);
    oncePainted(unseen::stop);
    oncePainted(next);
    frame.add(new WindowOutline());
    frame.setVisible(true);
    unseen.start();
  }

  /** Removes what has been shown before its parts were there. */
  void removeOutline() {
    frame.getContentPane().removeAll();
  }

  /** Has something done that people need not wait for when they have seen the window. */
  void oncePainted(Runnable work) {
    waiting.add(work);
  }

  private void painted() {
    List<Runnable> next = List.copyOf(waiting);
    waiting.clear();
    next.forEach(EventQueue::invokeLater);
  }

  /** Tells when all of it has been painted, which is after much else that follows its showing. */
  @SuppressWarnings("serial") // never written to a stream
  private final class PaintedFrame extends JFrame {
    PaintedFrame() {
      super("Pendant");
    }

    @Override
    protected JRootPane createRootPane() {
      JRootPane root =
          new JRootPane() {
            @Override
            public void paint(Graphics graphics) {
              super.paint(graphics);
              painted();
            }
          };
      root.setOpaque(true);
      return root;
    }
  }

  /** Gives it its picture, which takes longer to draw than anything in the window. */
  void drawIcon() {
    frame.setIconImages(icons());
  }

  private Rectangle remembered() {
    GraphicsEnvironment screens = GraphicsEnvironment.getLocalGraphicsEnvironment();
    return WindowBounds.parse(settings.get(BOUNDS).orElse(""))
        .flatMap(bounds -> WindowBounds.within(bounds, WindowBounds.screens()))
        .orElseGet(() -> WindowBounds.usual(screens.getMaximumWindowBounds()));
  }

  /** Whether a component is shown, in a window that is not minimised. */
  static boolean seen(Component component) {
    return component.isShowing()
        && !(SwingUtilities.getWindowAncestor(component) instanceof Frame frame
            && (frame.getExtendedState() & Frame.ICONIFIED) != 0);
  }

  /** Pendant's picture in the sizes that desktops ask for. */
  static List<Image> icons() {
    JLabel white = new JLabel();
    white.setForeground(Color.WHITE);
    List<Image> icons = new ArrayList<>();
    for (int size : new int[] {16, 32, 48, 128}) {
      BufferedImage image = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
      Graphics2D painter = image.createGraphics();
      painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      painter.setColor(GROUND);
      painter.fillRoundRect(0, 0, size, size, size / 3, size / 3);
      SvgIcon arm = Glyph.ROBOT.icon(size);
      double scale = 0.8 * size / arm.getIconWidth();
      painter.translate(0.1 * size, 0.08 * size);
      painter.scale(scale, scale);
      arm.paintIcon(white, painter, 0, 0);
      painter.dispose();
      icons.add(image);
    }
    return icons;
  }

  /** Remembers where it is, and closes it. */
  void end() {
    boolean maximized = (frame.getExtendedState() & Frame.MAXIMIZED_BOTH) == Frame.MAXIMIZED_BOTH;
    settings.put(MAXIMIZED, Boolean.toString(maximized));
    if (!maximized) {
      settings.put(BOUNDS, WindowBounds.format(frame.getBounds()));
    }
    frame.dispose();
  }
}
