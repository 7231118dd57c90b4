/**
 * State: what clients see of a controller: one immutable snapshot a frame. Open {@link
 * org.pendant.controller.state.ControllerState} first.
 */
package org.pendant.controller.state;
