package org.pendant.command;

import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.PictureRenderer;

/**
 * Services of the desktop; each is looked for when it is wanted, so that other commands start
 * without.
 *
 * @param launcher opens the window; empty where there is no desktop
 * @param renderers draw pictures; empty where there is no desktop
 */
record DesktopServices(
    Supplier<Optional<DesktopLauncher>> launcher,
    Supplier<Optional<PictureRenderer.Factory>> renderers) {

  /** Those that are on the class path. */
  static DesktopServices ofClassPath() {
    return new DesktopServices(
        () -> ServiceLoader.load(DesktopLauncher.class).findFirst(),
        () -> ServiceLoader.load(PictureRenderer.Factory.class).findFirst());
  }
}
