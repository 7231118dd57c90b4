package org.pendant.desktop.move;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import com.formdev.flatlaf.fonts.inter.FlatInterFont;
import java.awt.EventQueue;
import javax.swing.JFrame;
import javax.swing.Timer;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;

/** Shows the screen to try it by hand: {@code MovePreview light|dark WIDTH HEIGHT [off]}. */
public final class MovePreview {
  private static final int REFRESH_MS = 33;

  private MovePreview() {}

  /** Opens the window; the process ends with it. */
  public static void main(String[] args) {
    boolean off = args.length > 3 && args[3].equals("off");
    RobotSession session = RobotSession.start(ControllerOptions.headless().withPower(!off));
    EventQueue.invokeLater(() -> open(args, session));
  }

  private static void open(String[] args, RobotSession session) {
    FlatInterFont.install();
    FlatLaf.setPreferredFontFamily(FlatInterFont.FAMILY);
    FlatLaf.setup(args[0].equals("dark") ? new FlatDarkLaf() : new FlatLightLaf());
    MoveView view = new MoveView(new PreviewWorkbench(session));
    JFrame frame = new JFrame(view.title());
    frame.setDefaultCloseOperation(JFrame.EXIT_ON_CLOSE);
    frame.add(view.component());
    frame.setSize(Integer.parseInt(args[1]), Integer.parseInt(args[2]));
    frame.setVisible(true);
    new Timer(REFRESH_MS, event -> view.refresh(session.state())).start();
  }
}
