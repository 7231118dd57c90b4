/**
 * The clock of a controller: how long a frame takes. Open {@link org.pendant.models.time.FrameTime}
 * first.
 */
package org.pendant.models.time;
