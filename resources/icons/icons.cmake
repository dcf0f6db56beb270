# Our icons; drawn on a 24 px grid, LINE and TONE are coloured at run time.
set(MOLDWRIGHT_ICONS
    block.svg bolt.svg brush.svg camera.svg candidates.svg cavity.svg check.svg close.svg compare.svg deform.svg
    direction.svg edges.svg ejector.svg erase.svg error.svg explode.svg export.svg eye-off.svg eye.svg finish.svg
    fit.svg flip.svg float.svg four.svg grow.svg guides.svg info.svg key.svg keys.svg lasso.svg lay-flat.svg link.svg
    measure.svg mold.svg moldwright.svg move.svg ok.svg one.svg open.svg overflow.svg part.svg pause.svg
    perspective.svg pin-inside.svg pin.svg plane.svg play.svg pocket.svg print.svg proof.svg redo.svg region.svg
    report.svg restore.svg result.svg running.svg save.svg scale.svg search.svg section.svg see-through.svg select.svg
    slit.svg spout.svg stale.svg steel.svg stop.svg todo.svg tour.svg turn.svg turntable.svg two.svg undo.svg
    variants.svg vent.svg warn.svg)
