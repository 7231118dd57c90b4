package org.pendant.window;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;

/** The form of every kind of node in one picture, as the window shows them. */
final class FormSheet {
  private static final int COLUMNS = 10;
  private static final int GAP_PX = 8;

  private FormSheet() {}

  /**
   * Writes a program with a node of every kind, and the installation that it refers to, beside
   * settings that open them.
   *
   * @param settings folder of a window that is not open yet
   */
  static void prepare(Path settings) throws IOException {
    Path program = settings.resolve("every_node.pendant");
    Path installation = settings.resolve("every_node.pinst");
    copy("every_node.pendant", program);
    copy("every_node.pinst", installation);
    Files.writeString(
        Files.createDirectories(settings.resolve("pendant")).resolve("settings.txt"),
        "file.open = " + program + "\ninstallation.open = " + installation + "\n");
  }

  private static void copy(String resource, Path to) throws IOException {
    try (var in = FormSheet.class.getResourceAsStream(resource)) {
      if (in == null) {
        throw new IOException("there is no " + resource);
      }
      Files.write(to, in.readAllBytes());
    }
  }

  /** Goes through the program in front of a window, and draws all forms into a file. */
  static void write(OpenWindow window, Path file) throws IOException {
    Path each = Files.createTempFile("pendant-form", ".png");
    List<BufferedImage> forms = new ArrayList<>();
    window.click("rail-program");
    window.awaitShown("program-tree");
    for (String row : window.words("program-tree").lines().toList()) {
      window.clickRow("program-tree", row);
      window.settle();
      window.picture("node-form", each);
      forms.add(trimmed(ImageIO.read(each.toFile())));
    }
    Files.delete(each);
    ImageIO.write(SmallPicture.of(sheet(forms)), "png", file.toFile());
  }

  /** Without the empty space below, which is as the last row of pixels. */
  private static BufferedImage trimmed(BufferedImage form) {
    int bottom = form.getHeight();
    while (bottom > 2 && same(form, bottom - 2, form.getHeight() - 1)) {
      bottom--;
    }
    return form.getSubimage(0, 0, form.getWidth(), bottom);
  }

  private static boolean same(BufferedImage form, int row, int other) {
    for (int x = 0; x < form.getWidth(); x++) {
      if (form.getRGB(x, row) != form.getRGB(x, other)) {
        return false;
      }
    }
    return true;
  }

  /** Side by side, each below the shortest column so far. */
  private static BufferedImage sheet(List<BufferedImage> forms) {
    int width = forms.getFirst().getWidth() + GAP_PX;
    int[] bottoms = new int[COLUMNS];
    List<int[]> places = new ArrayList<>();
    for (BufferedImage form : forms) {
      int column = 0;
      for (int i = 1; i < COLUMNS; i++) {
        column = bottoms[i] < bottoms[column] ? i : column;
      }
      places.add(new int[] {column * width, bottoms[column]});
      bottoms[column] += form.getHeight() + GAP_PX;
    }
    int height = 0;
    for (int bottom : bottoms) {
      height = Math.max(height, bottom);
    }
    BufferedImage sheet = new BufferedImage(COLUMNS * width, height, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = sheet.createGraphics();
    pen.setColor(Color.GRAY);
    pen.fillRect(0, 0, sheet.getWidth(), sheet.getHeight());
    for (int i = 0; i < forms.size(); i++) {
      pen.drawImage(forms.get(i), places.get(i)[0], places.get(i)[1], null);
    }
    pen.dispose();
    return sheet;
  }
}
