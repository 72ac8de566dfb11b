% Stands in for the xlabel of Octave, which needs a graphics toolkit.
function xlabel(text)
end
