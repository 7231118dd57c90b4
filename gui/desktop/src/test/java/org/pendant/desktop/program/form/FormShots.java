package org.pendant.desktop.program.form;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JScrollPane;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.theme.PreviewLook;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.check.NodeProblem;

/** Writes a picture of each form: {@code FormShots light|dark WIDTH FOLDER [KIND...]}. */
public final class FormShots {
  private static final int TALLEST = 1700;

  private final FakeHost host;
  private final RobotSession session;
  private JFrame frame;
  private NodeForms forms;

  private FormShots(RobotSession session) {
    this.session = session;
    host = new FakeHost(EveryNode.tree(session.state()), session.state());
    host.setInstallation(EveryNode.installation());
  }

  /** Writes the pictures and ends. */
  public static void main(String[] args)
      throws IOException, InterruptedException, InvocationTargetException {
    Path folder = Files.createDirectories(Path.of(args[2]));
    FormShots shots = new FormShots(RobotSession.start(ControllerOptions.headless()));
    EventQueue.invokeAndWait(() -> shots.open(args[0].equals("dark"), Integer.parseInt(args[1])));
    int number = 0;
    for (ProgramNode node : shots.host.tree().nodes()) {
      number++;
      shots.shoot(
          Optional.of(node),
          folder.resolve("%03d-%s.png".formatted(number, node.step().getClass().getSimpleName())));
    }
    shots.shoot(Optional.empty(), folder.resolve("000-nothing.png"));
    System.exit(0); // the window keeps the process alive otherwise
  }

  private void open(boolean dark, int width) {
    PreviewLook.install(dark);
    forms = new NodeForms(new PreviewWorkbench(session), host);
    ProgramNode first = host.tree().nodes().get(3);
    host.addProblem(new NodeProblem(first.key(), "speed", "is 0, must be above 0"));
    frame = new JFrame("Forms");
    frame.setUndecorated(true);
    frame.add(forms.component());
    frame.setSize(width, TALLEST);
    frame.setVisible(true);
  }

  private void shoot(Optional<ProgramNode> node, Path file)
      throws IOException, InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(() -> forms.show(node));
    Thread.sleep(400); // expressions are read after a pause in typing
    for (int i = 0; i < 4; i++) {
      EventQueue.invokeAndWait(() -> frame.validate());
    }
    BufferedImage[] image = new BufferedImage[1];
    EventQueue.invokeAndWait(() -> image[0] = picture());
    ImageIO.write(image[0], "png", file.toFile());
  }

  private BufferedImage picture() {
    JComponent shown = forms.component();
    Dimension whole = ((JScrollPane) shown).getViewport().getView().getPreferredSize();
    int height = Math.min(whole.height, shown.getHeight());
    BufferedImage image =
        new BufferedImage(shown.getWidth(), Math.max(height, 60), BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = image.createGraphics();
    shown.printAll(pen);
    pen.dispose();
    return image;
  }
}
