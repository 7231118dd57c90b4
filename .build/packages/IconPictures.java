import com.github.weisj.jsvg.SVGDocument;
import com.github.weisj.jsvg.parser.SVGLoader;
import com.github.weisj.jsvg.view.ViewBox;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;

/** The icon in the sizes that desktops look for. */
final class IconPictures {
  private IconPictures() {}

  /** Draws {@code icon} into the folders of a theme of icons. */
  static void draw(Path icon, Path theme) throws IOException {
    SVGDocument drawing = load(icon);
    for (int size : new int[] {16, 24, 32, 48, 64, 128, 256}) {
      Path folder = theme.resolve(size + "x" + size).resolve("apps");
      Files.createDirectories(folder);
      ImageIO.write(picture(drawing, size), "png", folder.resolve("pendant.png").toFile());
    }
  }

  static SVGDocument load(Path icon) throws IOException {
    return Optional.ofNullable(new SVGLoader().load(icon.toUri().toURL()))
        .orElseThrow(() -> new IOException(icon + " is no drawing"));
  }

  /** A square of {@code size} pixels. */
  static BufferedImage picture(SVGDocument drawing, int size) {
    BufferedImage picture = new BufferedImage(size, size, BufferedImage.TYPE_INT_ARGB);
    Graphics2D painter = picture.createGraphics();
    painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    painter.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    drawing.render(null, painter, new ViewBox(size, size));
    painter.dispose();
    return picture;
  }
}
