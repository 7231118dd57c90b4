package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.ServiceLoader;
import org.junit.jupiter.api.Test;
import org.pendant.command.service.DesktopLauncher;

final class WindowLauncherTest {

  @Test
  void theCommandLineFindsIt() {
    assertInstanceOf(
        WindowLauncher.class, ServiceLoader.load(DesktopLauncher.class).findFirst().orElseThrow());
  }
}
