package org.pendant.controller.freedrive;

/**
 * Freedrive mode.
 *
 * @param holder who asks for it
 * @param axes which axes are free
 * @param frame whose axes these are
 * @param payloadChecked whether a wrong payload refuses or ends it (manual 15.19)
 */
public record FreedriveMode(
    FreedriveHolder holder, FreeAxes axes, FreedriveFrame frame, boolean payloadChecked) {

  /** All axes free. */
  public static FreedriveMode free(FreedriveHolder holder, boolean payloadChecked) {
    return new FreedriveMode(holder, FreeAxes.ALL, FreedriveFrame.BASE, payloadChecked);
  }
}
