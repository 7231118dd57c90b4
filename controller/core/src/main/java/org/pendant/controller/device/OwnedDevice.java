package org.pendant.controller.device;

import org.pendant.models.json.FilePosition;

/**
 * Device of one of the controllers in a cell: its signals are those of that controller.
 *
 * @param owner number of the controller, in the order of the file
 * @param setup what it is
 * @param place where the file has it
 */
public record OwnedDevice(int owner, DeviceSetup setup, FilePosition place) {}
