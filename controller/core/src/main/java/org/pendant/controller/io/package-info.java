/**
 * The signals of the control box: digital and analog ones, flags, registers, the tool connector.
 * Open {@link org.pendant.controller.io.Signals} first.
 */
package org.pendant.controller.io;
