/**
 * The digital signals of the control box: inputs, outputs and flags. Open {@link
 * org.pendant.controller.io.DigitalIo} first.
 */
package org.pendant.controller.io;
