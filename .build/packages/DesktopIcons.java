import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.ImageIO;

/**
 * The icon in the forms that jpackage wants: {@code pendant.ico} for Windows, {@code pendant.icns}
 * for macOS.
 */
final class DesktopIcons {
  private static final int[] WINDOWS = {16, 24, 32, 48, 64, 128, 256};

  /** Sides of the pictures of macOS by the types that stand for them. */
  private static final Map<String, Integer> MACOS = new LinkedHashMap<>();

  static {
    MACOS.put("ic11", 32); // 16 on fine screens
    MACOS.put("ic12", 64); // 32 on fine screens
    MACOS.put("ic07", 128);
    MACOS.put("ic08", 256);
    MACOS.put("ic09", 512);
    MACOS.put("ic10", 1024); // 512 on fine screens
  }

  private DesktopIcons() {}

  /**
   * Writes both.
   *
   * @param words the project's folder and the one that they go to
   */
  public static void main(String[] words) throws IOException {
    if (words.length != 2) {
      System.err.println("expected the project's folder and a folder for the icons");
      System.exit(2);
    }
    Path drawing = Path.of(words[0]).resolve(".build/packages/linux/pendant.svg");
    Path folder = Files.createDirectories(Path.of(words[1]));
    Files.write(folder.resolve("pendant.ico"), ico(drawing));
    Files.write(folder.resolve("pendant.icns"), icns(drawing));
  }

  /** A directory of entries, then their pictures. */
  private static byte[] ico(Path drawing) throws IOException {
    ByteBuffer directory =
        ByteBuffer.allocate(6 + 16 * WINDOWS.length).order(ByteOrder.LITTLE_ENDIAN);
    directory.putShort((short) 0).putShort((short) 1).putShort((short) WINDOWS.length);
    ByteArrayOutputStream pictures = new ByteArrayOutputStream();
    for (int size : WINDOWS) {
      byte[] picture = png(drawing, size);
      byte side = (byte) size; // 0 is 256
      directory.put(side).put(side).put((byte) 0).put((byte) 0);
      directory.putShort((short) 1).putShort((short) 32);
      directory.putInt(picture.length).putInt(directory.capacity() + pictures.size());
      pictures.write(picture);
    }
    ByteArrayOutputStream icon = new ByteArrayOutputStream();
    icon.write(directory.array());
    pictures.writeTo(icon);
    return icon.toByteArray();
  }

  /** Blocks of a type, a length with these eight bytes, and a picture, in such a block. */
  private static byte[] icns(Path drawing) throws IOException {
    ByteArrayOutputStream blocks = new ByteArrayOutputStream();
    for (Map.Entry<String, Integer> each : MACOS.entrySet()) {
      blocks.write(block(each.getKey(), png(drawing, each.getValue())));
    }
    return block("icns", blocks.toByteArray());
  }

  private static byte[] block(String type, byte[] content) {
    return ByteBuffer.allocate(8 + content.length)
        .put(type.getBytes(StandardCharsets.US_ASCII))
        .putInt(8 + content.length)
        .put(content)
        .array();
  }

  private static byte[] png(Path drawing, int size) throws IOException {
    ByteArrayOutputStream picture = new ByteArrayOutputStream();
    ImageIO.write(IconPictures.picture(IconPictures.load(drawing), size), "png", picture);
    return picture.toByteArray();
  }
}
