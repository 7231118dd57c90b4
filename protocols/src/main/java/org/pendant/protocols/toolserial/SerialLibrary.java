package org.pendant.protocols.toolserial;

import static org.pendant.protocols.toolserial.ToolSerialTexts.text;

import com.fazecast.jSerialComm.SerialPort;
import java.io.IOException;
import org.pendant.protocols.natives.NativeFolder;

/**
 * Serial library: loads jSerialComm from a folder that only this user can write.
 *
 * <p>While its class is initialised, that library empties a folder of a known name among the
 * temporary files, following links, then loads what it finds or unpacks there, open to all users.
 * The only way to another place is what it takes for the folder of temporary files and for the
 * home.
 */
final class SerialLibrary {
  private static final String TEMPORARY = "java.io.tmpdir";
  private static final String HOME = "user.home";

  private SerialLibrary() {}

  /**
   * Loads it; does nothing when that has been done.
   *
   * @throws IOException when there is no safe folder, or the library is not made for this computer
   */
  static synchronized void load() throws IOException {
    String folder = NativeFolder.ofUser().toString();
    String temporary = System.getProperty(TEMPORARY);
    String home = System.getProperty(HOME);
    try {
      System.setProperty(TEMPORARY, folder);
      System.setProperty(HOME, folder);
      Class.forName(SerialPort.class.getName());
    } catch (ClassNotFoundException | LinkageError e) {
      throw new IOException(text("cannotBeUsedHere", e.getMessage()), e);
    } finally {
      restore(TEMPORARY, temporary);
      restore(HOME, home);
    }
  }

  private static void restore(String name, String value) {
    if (value == null) {
      System.clearProperty(name);
    } else {
      System.setProperty(name, value);
    }
  }
}
